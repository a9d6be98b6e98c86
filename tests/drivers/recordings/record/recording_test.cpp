#include "drivers/recordings/record/recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "drivers/recordings/mcap/encoder.hpp"
#include "drivers/recordings/record/recover.hpp"
#include "tests/drivers/recordings/mcap/read_back.hpp"

namespace drydock::record {
namespace recording_test {

constexpr Stamp start = measurement::stamp_from_ns(1'700'000'000'000'000'000);

/// A recording of `seconds`, with ten reads a second of a serial line and ten frames a second of a
/// bus.
std::string recorded(int seconds) {
  RecorderOptions options;
  options.links = {{"pty:dvl?baud=115200", "dvl", false, {"dvl"}},
                   {"can:auto?name=can0", "can0", true, {"imu", "depth"}}};
  options.devices = {{"imu", bus::Kind::imu}};
  options.attachments = {{0, 0, "rig.toml", "application/toml", "[rig]\n"}};
  options.when_behind = WhenBehind::wait;
  std::string file;
  Recorder recorder(
      [&](mcap::Bytes bytes) {
        file.append(bytes.begin(), bytes.end());
        return boost::system::error_code{};
      },
      options);
  for (int i = 0; i < 10 * seconds; ++i) {
    const Stamp at = start + i * std::chrono::milliseconds{100};
    const std::array<std::uint8_t, 2> bytes{0x7F, static_cast<std::uint8_t>(i)};
    recorder.on_bytes("pty:dvl?baud=115200", Direction::received, bytes, at);
    wire::CanFrame frame;
    frame.id = 0x100u + static_cast<std::uint32_t>(i);
    recorder.on_frame("can:auto?name=can0", Direction::sent, frame, at);
    measurement::ImuSample imu;
    imu.origin.valid_at = imu.origin.received_at = at;
    recorder.topics().publish(imu);
  }
  EXPECT_FALSE(recorder.finish());
  return file;
}

std::filesystem::path written(const std::string& content) {
  const auto path = std::filesystem::path(testing::TempDir()) / "drydock-recording.mcap";
  std::ofstream(path, std::ios::binary) << content;
  return path;
}

/// The same file as other programs write it that cut or sort recordings: a channel stands in front
/// of its own first message, attachments behind all of them.
std::string rewritten(const std::string& file, bool with_summary) {
  mcap::Reader reader(std::make_unique<std::istringstream>(file));
  mcap::Buffer out(mcap::magic.begin(), mcap::magic.end());
  mcap::encode(out, mcap::Header{"", "another program"});
  std::map<std::uint16_t, mcap::Schema> schemas;
  std::map<std::uint16_t, mcap::Channel> channels;
  std::vector<mcap::Attachment> attachments;
  std::set<std::uint16_t> begun;
  while (const auto record = reader.next()) {
    if (const auto* schema = std::get_if<mcap::Schema>(&*record)) schemas[schema->id] = *schema;
    if (const auto* one = std::get_if<mcap::Channel>(&*record)) channels[one->id] = *one;
    if (const auto* one = std::get_if<mcap::Attachment>(&*record)) attachments.push_back(*one);
    const auto* message = std::get_if<mcap::Message>(&*record);
    if (message == nullptr) continue;
    if (begun.insert(message->channel).second) {
      mcap::encode(out, schemas.at(channels.at(message->channel).schema));
      mcap::encode(out, channels.at(message->channel));
    }
    mcap::encode(out, *message);
  }
  std::vector<std::pair<std::uint64_t, std::uint64_t>> places;
  for (const auto& attachment : attachments) {
    const auto at = out.size();
    mcap::encode(out, attachment);
    places.emplace_back(at, out.size() - at);
  }
  mcap::Encoder encoder(out);
  encoder.record(mcap::Opcode::data_end, [&] { encoder.number(std::uint32_t{0}); });
  const std::uint64_t summary = with_summary ? out.size() : 0;
  if (with_summary) {
    for (const auto& [id, schema] : schemas) mcap::encode(out, schema);
    for (const auto& [id, channel] : channels) mcap::encode(out, channel);
    for (const auto& place : places)
      encoder.record(mcap::Opcode::attachment_index,
                     [&] { encoder.number(place.first).number(place.second); });
  }
  encoder.record(mcap::Opcode::footer, [&] {
    encoder.number(summary).number(std::uint64_t{0}).number(std::uint32_t{0});
  });
  out.insert(out.end(), mcap::magic.begin(), mcap::magic.end());
  return {out.begin(), out.end()};
}

TEST(Recording, OfAnotherProgramIsReadByItsSummary) {
  auto recording = Recording::open(written(rewritten(recorded(5), true))).value();
  ASSERT_EQ(recording.links().size(), 2U);
  EXPECT_EQ(recording.attachment("rig.toml"), "[rig]\n");
  std::array<int, 2> of_link{};
  while (const auto event = recording.next())
    if (const auto* raw = std::get_if<RawEvent>(&*event)) ++of_link.at(raw->link);
  EXPECT_EQ(of_link, (std::array{50, 50}));
  EXPECT_EQ(recording.damage(), "");
  EXPECT_EQ(recording.clock_note(), "");
}

TEST(Recording, LinksThatNobodyKnewAtTheBeginningAreLeftOutAndTold) {
  auto recording = Recording::open(written(rewritten(recorded(5), false))).value();
  ASSERT_EQ(recording.links().size(), 1U);
  int raw = 0;
  while (const auto event = recording.next()) raw += std::holds_alternative<RawEvent>(*event);
  EXPECT_EQ(raw, 50);
  EXPECT_EQ(recording.links().size(), 1U);
  EXPECT_EQ(recording.unreadable(), 50U);
  EXPECT_THAT(recording.clock_note(), testing::HasSubstr("1 links begin behind other data"));
}

TEST(Recording, GivesBackEveryByteAndFrameInOrderWithItsTime) {
  auto recording = Recording::open(written(recorded(5))).value();
  ASSERT_EQ(recording.links().size(), 2U);
  EXPECT_EQ(recording.links()[0].uri, "pty:dvl?baud=115200");
  EXPECT_EQ(recording.links()[1].devices, (std::vector<std::string>{"imu", "depth"}));
  EXPECT_EQ(recording.attachment("rig.toml"), "[rig]\n");
  int bytes = 0, frames = 0, understood = 0;
  Stamp last{};
  while (const auto event = recording.next()) {
    if (const auto* known = std::get_if<Understood>(&*event)) {
      EXPECT_EQ(known->schema->name, "sensor_msgs/msg/Imu");
      ++understood;
      continue;
    }
    const auto& raw = std::get<RawEvent>(*event);
    EXPECT_GE(raw.at(), last);
    last = raw.at();
    if (const auto* read = std::get_if<RawBytes>(&raw.content)) {
      EXPECT_EQ(read->at, start + bytes * std::chrono::milliseconds{100});
      EXPECT_EQ(read->data[1], bytes++);
    } else {
      EXPECT_EQ(raw.direction(), Direction::sent);
      EXPECT_EQ(std::get<RawFrame>(raw.content).frame.id, 0x100U + static_cast<unsigned>(frames++));
    }
  }
  EXPECT_EQ(bytes, 50);
  EXPECT_EQ(frames, 50);
  EXPECT_EQ(understood, 50);
  EXPECT_EQ(recording.damage(), "");
}

TEST(Recording, OfAFileThatIsNotThereOrNotOneSaysSoInALine) {
  EXPECT_EQ(Recording::open("/nowhere/dive.mcap").error().line,
            "/nowhere/dive.mcap: No such file or directory");
  const auto path = written("$GPGGA,no recording");
  EXPECT_EQ(Recording::open(path).error().line, path.string() + ": byte 0: not an MCAP file");
}

TEST(Recover, MakesACutFileWholeUpToItsLastChunk) {
  const std::string whole = recorded(8);
  mcap::Reader cut(std::make_unique<std::istringstream>(whole.substr(0, whole.size() * 6 / 10)));
  const auto path = std::filesystem::path(testing::TempDir()) / "drydock-recovered.mcap";
  const Recovered recovered = recover(cut, mcap::file_sink(path, true).value());
  EXPECT_FALSE(recovered.error);
  EXPECT_THAT(recovered.damage, testing::HasSubstr("the file is cut here"));
  EXPECT_GT(recovered.messages, 60U);
  EXPECT_LT(recovered.messages, 240U);
  EXPECT_EQ(recovered.attachments, 1U);

  DRYDOCK_NEEDS_NODE();
  auto found = mcap::test::read_back(path);
  ASSERT_FALSE(found.contains("indexedError")) << found["indexedError"];
  EXPECT_EQ(found["indexed"]["statistics"]["messageCount"], std::to_string(recovered.messages));
  EXPECT_EQ(found["indexed"]["statistics"]["messageEndTime"], std::to_string(recovered.last_time));
  EXPECT_EQ(found["indexed"]["profile"], "ros2");
}

TEST(Recover, MendsAFileOfWhichOnlyTheSummaryIsCut) {
  const std::string whole = recorded(3);
  mcap::Reader cut(std::make_unique<std::istringstream>(whole.substr(0, whole.size() - 20)));
  const auto nowhere = [](mcap::Bytes) { return boost::system::error_code{}; };
  const Recovered recovered = recover(cut, nowhere);
  EXPECT_THAT(recovered.damage, testing::HasSubstr("in its summary"));
  EXPECT_EQ(recovered.messages, 90U);
}

TEST(Recover, LeavesAWholeFileAsItIs) {
  mcap::Reader source(std::make_unique<std::istringstream>(recorded(3)));
  std::string copy;
  const auto sink = [&](mcap::Bytes bytes) {
    copy.append(bytes.begin(), bytes.end());
    return boost::system::error_code{};
  };
  const Recovered recovered = recover(source, sink);
  EXPECT_EQ(recovered.damage, "");
  EXPECT_EQ(recovered.messages, 90U);
}

}  // namespace recording_test
}  // namespace drydock::record
