#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "drivers/recordings/mcap/file_sink.hpp"
#include "drivers/recordings/mcap/writer.hpp"
#include "drivers/recordings/record/player.hpp"
#include "drivers/recordings/tasks/fixture.hpp"
#include "tests/drivers/decode/captured.hpp"
#include "tests/drivers/recordings/mcap/read_back.hpp"
#include "tests/drivers/recordings/sample_dive/sample_dive.hpp"
#include "tests/test_name.hpp"

/// Plays every dive in fixtures/dives, made by `drydock cut --as-fixture`, through the drivers
/// again. The test must notice a single changed byte.
namespace drydock::recordings {
namespace dives_test {

namespace fs = std::filesystem;

const fs::path all_dives = DRYDOCK_SOURCE_DIR "/fixtures/dives";
constexpr std::size_t mutations = 24;  ///< for each dive, spread over its length

std::vector<std::string> dives() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(all_dives))
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string played(const std::string& recording) {
  decode::MemoryFile now;
  const auto measurements = write_reference(recording, now.file());
  if (!measurements) return measurements.error().line;
  EXPECT_GT(*measurements, 0U);
  return now.text();
}

/// Copies a recording record by record and changes one received byte.
class Mutant {
 public:
  explicit Mutant(const std::string& path)
      : path_(path), recording_(record::Recording::open(path).value()) {}

  std::size_t received() {
    std::size_t count = 0;
    for_each_record([&](mcap::Record& record) { count += received_data(record) != nullptr; });
    return count;
  }

  /// Flips a bit of the `nth` received read or frame.
  void write(const std::string& to, std::size_t nth, std::size_t byte) {
    std::optional<mcap::Writer> out;
    std::vector<std::uint8_t> changed;
    std::size_t at = 0;
    for_each_record([&](mcap::Record& record) {
      if (received_data(record) != nullptr && at++ == nth) {
        auto& message = std::get<mcap::Message>(record);
        changed.assign(message.data.begin(), message.data.end());
        const std::size_t data = data_begin(message);
        changed[data + byte % (changed.size() - data)] ^= 0x10;
        message.data = changed;
      }
      std::visit([&](const auto& r) { copy(out, r, to); }, record);
    });
    ASSERT_FALSE(out->finish());
  }

 private:
  template <class See>
  void for_each_record(See see) {
    mcap::Reader reader(std::make_unique<std::ifstream>(path_, std::ios::binary));
    while (auto record = reader.next()) see(*record);
    ASSERT_EQ(reader.damage(), "");
  }

  static void copy(std::optional<mcap::Writer>& out, const mcap::Header& header,
                   const std::string& to) {
    out.emplace(mcap::file_sink(to, true).value(), header);
  }
  static void copy(std::optional<mcap::Writer>&, const mcap::DataEnd&, const std::string&) {}
  static void copy(std::optional<mcap::Writer>& out, const auto& record, const std::string&) {
    out->add(record);
  }

  /// Null for other messages, and for empty data: they have no byte to change.
  const mcap::Message* received_data(const mcap::Record& record) const {
    const auto* message = std::get_if<mcap::Message>(&record);
    if (message == nullptr || !recording_.link_of(message->channel)) return nullptr;
    const bool received = message->data[12] == 0;  // drydock/RawBytes, drydock/CanFrame: direction
    return received && message->data.size() > data_begin(*message) ? message : nullptr;
  }
  /// Position of the data of a read or frame in its CDR: the last sequence.
  std::size_t data_begin(const mcap::Message& message) const {
    return recording_.links()[*recording_.link_of(message.channel)].frames ? 32 : 20;
  }

  std::string path_;
  record::Recording recording_;
};

/// Removes the sums over the links. The rest shows what the drivers alone notice.
std::string without_sums(const std::string& account) {
  std::string kept;
  std::istringstream in(account);
  for (std::string line; std::getline(in, line);)
    if (line.find("\"crc32\"") == std::string::npos) kept += line + '\n';
  return kept;
}

/// Plays the dive of a folder and compares it with its reference. Empty if they are equal byte for
/// byte, otherwise the first different line.
std::string difference(const fs::path& folder, bool with_sums = true) {
  const auto lines = [&](const std::string& text) { return with_sums ? text : without_sums(text); };
  std::istringstream expected(lines(record::test::read_all(folder / fixture_reference)));
  std::istringstream now(lines(played(folder / fixture_recording)));
  for (std::size_t number = 1;; ++number) {
    std::string want, got;
    const bool more = static_cast<bool>(std::getline(expected, want));
    if (!std::getline(now, got) && !more) return {};
    if (want != got)
      return "line " + std::to_string(number) + ": expected\n" + want + "\ngot\n" + got;
  }
}

class Dive : public testing::TestWithParam<std::string> {
 protected:
  void copy_to(const fs::path& folder) const {
    fs::copy(folder_ / fixture_recording, folder, fs::copy_options::overwrite_existing);
    fs::copy(folder_ / fixture_reference, folder, fs::copy_options::overwrite_existing);
  }

  fs::path folder_ = all_dives / GetParam();
};

TEST_P(Dive, GoesThroughTheDriversAsItDidWhenItWasKept) { EXPECT_EQ(difference(folder_), ""); }

TEST_P(Dive, OfWhichOneReceivedByteIsChangedIsAnother) {
  const record::test::TestFolder copy;
  copy_to(copy / "");
  Mutant mutant(folder_ / fixture_recording);
  const std::size_t received = mutant.received();
  ASSERT_GT(received, 0U);
  std::size_t seen_by_drivers = 0;
  for (std::size_t i = 0; i < mutations; ++i) {
    mutant.write(copy / fixture_recording, i * received / mutations, 5 * i);
    EXPECT_NE(difference(copy / ""), "") << "byte " << 5 * i << " of " << i * received / mutations;
    seen_by_drivers += !difference(copy / "", false).empty();
  }
  // In a CAN frame some bytes are reserved, and no checksum protects them.
  EXPECT_GE(4 * seen_by_drivers, mutations) << seen_by_drivers << " of " << mutations;
}

TEST_P(Dive, WhoseReferenceHasOneOtherByteDoesNotFitIt) {
  const record::test::TestFolder copy;
  const std::string reference = record::test::read_all(folder_ / fixture_reference);
  for (std::size_t i = 0; i < mutations; ++i) {
    copy_to(copy / "");
    std::string changed = reference;
    changed[i * reference.size() / mutations] ^= 0x01;
    std::ofstream(copy / fixture_reference, std::ios::binary) << changed;
    EXPECT_NE(difference(copy / ""), "") << "byte " << i * reference.size() / mutations;
  }
}

TEST_P(Dive, IsSoundToTheFormatsOwnReader) {
  DRYDOCK_NEEDS_NODE();
  const auto found = mcap::test::read_back(folder_ / fixture_recording);
  ASSERT_FALSE(found.contains("indexedError")) << found["indexedError"];
  ASSERT_FALSE(found.contains("streamedError")) << found["streamedError"];
  std::uint64_t messages = 0;
  for (const auto& topic : found["indexed"]["topics"])
    messages += topic["count"].get<std::uint64_t>();
  EXPECT_EQ(found["indexed"]["statistics"]["messageCount"], std::to_string(messages));
  EXPECT_EQ(found["streamed"]["done"], true);
}

/// The kinds of device in the dives, from their rig files.
TEST(Dives, AreSevenOrMoreAndHaveEveryKindOfDevice) {
  EXPECT_GE(dives().size(), 7U);
  std::set<rig_config::DeviceKind> kinds;
  for (const auto& dive : dives()) {
    const auto recording = record::Recording::open(all_dives / dive / fixture_recording);
    ASSERT_TRUE(recording) << dive;
    for (const auto& device : record::rig_of(*recording).value().devices) kinds.insert(device.kind);
  }
  EXPECT_EQ(kinds.size(), 6U);
}

INSTANTIATE_TEST_SUITE_P(Fixtures, Dive, testing::ValuesIn(dives()),
                         [](const auto& dive) { return drydock::test::test_name(dive.param); });

}  // namespace dives_test
}  // namespace drydock::recordings
