#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "drivers/wire/hex.hpp"
#include "tests/drivers/capture/captures.hpp"
#include "tests/drivers/property.hpp"

/// Rules for every format, checked with the files of fixtures/capture: each holds the same frames.
namespace drydock::capture::testing {
namespace conformance_test {

using std::chrono::nanoseconds;
using wire::testing::fixture;
using namespace std::chrono_literals;

/// The parts of the eight frames in expected.jsonl that a file can express.
struct Sample {
  const char* file;
  const char* format;
  std::vector<std::size_t> frames;
  bool names_bus = true;
  bool says_switched = true;  ///< it can mark the faster data phase of a CAN FD frame
  enum Times { absolute, from_start, of_day, none } times = absolute;
  nanoseconds resolution = 0ns;
};

void PrintTo(const Sample& sample, std::ostream* out) { *out << sample.file; }
bool is_text(const Sample& sample) {
  const std::string format = sample.format;
  return !format.starts_with("pcap") && format != "blf";
}

std::string test_name(const ::testing::TestParamInfo<Sample>& sample) {
  std::string name = sample.param.file;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
}

const std::vector<std::size_t> all{0, 1, 2, 3, 4, 5, 6, 7}, classic{0, 1, 2, 3, 4, 5};

const Sample samples[] = {
    {"frames.log", "candump-log", all},
    {"cr.log", "candump-log", all},
    {"crlf.log", "candump-log", all},
    {"screen.txt", "candump-screen", all},
    {"long.txt", "candump-screen", all, true, false},
    {"angled.txt", "candump-screen", {0, 1, 3, 4}, false, false, Sample::none},
    {"hex.asc", "asc", all},
    {"dec.asc", "asc", all},
    {"canutils.asc", "asc", all},
    {"v1.0.trc", "trc", {0, 1, 2, 3, 4}, false, false, Sample::from_start, 1ms},
    {"v1.1.trc", "trc", classic, false, false, Sample::absolute, 10us},
    {"v1.3.trc", "trc", classic, true, false, Sample::absolute, 10us},
    {"v2.0.trc", "trc", all, false, true, Sample::absolute, 10us},
    {"v2.1.trc", "trc", all, true, true, Sample::absolute, 10us},
    {"plain.csv", "canboat", {1, 3}, false, false},
    {"actisense.txt", "actisense", {1, 3}, false, false, Sample::of_day, 1ms},
    {"ydwg.txt", "ydwg", {1, 3}, false, false, Sample::of_day, 1ms},
    {"ikonvert.txt", "ikonvert", {1, 3}, false, false, Sample::from_start, 1ms},
    {"savvycan.csv", "savvycan", {0, 1, 3, 4, 6, 7}, true, false},
    {"savvycan-v1.csv", "savvycan", {0, 1, 3, 4, 6, 7}, true, false},
    {"busmaster.log", "busmaster", {0, 1, 2, 3, 4}, true, false, Sample::absolute, 100us},
    {"crtd.txt", "crtd", {0, 1, 3, 4}, true, false},
    {"ixxat.csv", "ixxat", {0, 1, 2, 3, 4}, true, false, Sample::of_day, 500us},
    {"minimon.csv", "ixxat", {0, 1, 2, 3, 4}, false, false, Sample::of_day, 500us},
    {"kvaser.csv", "kvaser", all},
    {"table.csv", "python-can", all, false, false},
    {"le_us.pcap", "pcap", all, false},
    {"be_ns.pcap", "pcap", all, false},
    {"le.pcapng", "pcapng", all},
    {"be.pcapng", "pcapng", all},
    {"frames.blf", "blf", all, true, true, Sample::absolute, 1us},
};

std::vector<nlohmann::json> expected_frames() {
  const Buffer text = fixture("capture/expected.jsonl");
  std::istringstream lines(std::string(text.begin(), text.end()));
  std::vector<nlohmann::json> frames;
  for (std::string line; std::getline(lines, line);) frames.push_back(nlohmann::json::parse(line));
  return frames;
}

class EachFormat : public ::testing::TestWithParam<Sample> {
 protected:
  Buffer bytes = fixture(std::string("capture/") + GetParam().file);
};
class EachTextFormat : public EachFormat {};  // a binary file has no lines

void expect_frame(const Sample& sample, const Seen& seen, const nlohmann::json& expected) {
  const wire::CanFrame& frame = seen.frame;
  EXPECT_EQ(frame.id, expected["id"]);
  EXPECT_EQ(frame.extended, expected["extended"]);
  EXPECT_EQ(frame.remote, expected["remote"]);
  EXPECT_EQ(frame.error, expected["error"]);
  EXPECT_EQ(frame.fd, expected["fd"]);
  EXPECT_EQ(frame.size, expected["size"]);
  EXPECT_EQ(frame.remote ? "" : wire::HexText(frame.payload()).view(), expected["data"]);
  EXPECT_TRUE(!sample.says_switched || frame.bit_rate_switch == expected["bit_rate_switch"]);
  EXPECT_EQ(seen.interface, sample.names_bus ? expected["interface"] : "can0");
  EXPECT_EQ(seen.time.has_value(), sample.times != Sample::none);
  if (!seen.time) return;
  nanoseconds time{expected["time_ns"].get<std::int64_t>()};
  if (sample.times == Sample::from_start) time %= 1s;
  if (sample.times == Sample::of_day) time %= 24h;
  EXPECT_LE(abs(*seen.time - time), sample.resolution);
}

TEST_P(EachFormat, IsRecognisedByItsContentAndGivesTheFramesThatWereWritten) {
  const Outcome outcome = read_capture(bytes);
  const auto expected = expected_frames();
  EXPECT_EQ(outcome.format, GetParam().format);
  ASSERT_EQ(outcome.records.size(), GetParam().frames.size());
  for (std::size_t i = 0; i < outcome.records.size(); ++i) {
    SCOPED_TRACE(i);
    expect_frame(GetParam(), outcome.records[i], expected[GetParam().frames[i]]);
  }
  EXPECT_EQ(outcome.damaged, 0u);
  EXPECT_EQ(outcome.bytes_skipped, 0u);
}

TEST_P(EachFormat, GivesTheSameInAnySplit) {
  const Outcome whole = read_capture(bytes);
  EXPECT_EQ(read_capture(bytes, {1}), whole);
  EXPECT_TRUE(holds([&] {
    const auto pieces = *rc::gen::nonEmpty(
        rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(1, 90)));
    RC_ASSERT(read_capture(bytes, pieces) == whole);
  }));
}

TEST_P(EachFormat, MayBeNamedInsteadOfRecognised) {
  EXPECT_EQ(read_capture(bytes, {1u << 16}, find_format(GetParam().format)), read_capture(bytes));
}

TEST_P(EachTextFormat, ALineThatIsNoneIsCountedWithItsNumberAndTheOthersAreRead) {
  const Outcome whole = read_capture(bytes);
  const std::string end = bytes.back() == '\r' ? "\r" : "\n";
  const Outcome outcome = read_capture(bytes + wire::testing::as_bytes("?!" + end) + bytes);
  EXPECT_EQ(outcome.damaged, 1u);
  EXPECT_EQ(outcome.where, std::vector<std::uint64_t>{whole.units + 1});
  EXPECT_EQ(outcome.records.size(), 2 * whole.records.size());
}

TEST_P(EachFormat, CutShortAnywhereGivesTheFramesBeforeTheCut) {
  const Outcome whole = read_capture(bytes);
  const Format* format = find_format(GetParam().format);
  for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 200) {
    const Outcome cut = read_capture(Bytes(bytes).first(size), {1u << 16}, format);
    ASSERT_LE(cut.records.size(), whole.records.size());
    // If the last line of a text is cut, it may still be a valid frame with fewer bytes.
    const std::size_t sure = cut.records.size() - (is_text(GetParam()) && !cut.records.empty());
    for (std::size_t i = 0; i < sure; ++i) ASSERT_EQ(cut.records[i], whole.records[i]);
    ASSERT_LE(cut.damaged, 1u);
  }
}

TEST_P(EachFormat, DamagedBytesDoNoHarmAndGiveOnlyFramesThatThereCanBe) {
  EXPECT_TRUE(holds([&] {
    Buffer damaged = bytes;
    const auto changes = *rc::gen::arbitrary<std::vector<std::pair<std::uint32_t, std::uint8_t>>>();
    for (const auto& [at, value] : changes) damaged[at % damaged.size()] = value;
    for (const Seen& seen : read_capture(damaged).records) {
      const wire::CanFrame& frame = seen.frame;
      RC_ASSERT(frame.id <= (frame.extended || frame.error ? 0x1FFFFFFFu : 0x7FFu));
      RC_ASSERT(frame.size <= (frame.fd ? 64 : 8));
    }
  }));
}

INSTANTIATE_TEST_SUITE_P(Capture, EachFormat, ::testing::ValuesIn(samples), test_name);

std::vector<Sample> text_samples() {
  std::vector<Sample> texts;
  std::ranges::copy_if(samples, std::back_inserter(texts), is_text);
  return texts;
}
INSTANTIATE_TEST_SUITE_P(Capture, EachTextFormat, ::testing::ValuesIn(text_samples()), test_name);

TEST(Capture, EveryFormatOfTheListIsTested) {
  std::set<std::string_view> tested, listed;
  for (const Sample& sample : samples) tested.insert(sample.format);
  for (const Format& format : formats()) listed.insert(format.name);
  EXPECT_EQ(tested, listed);
}

}  // namespace conformance_test
}  // namespace drydock::capture::testing
