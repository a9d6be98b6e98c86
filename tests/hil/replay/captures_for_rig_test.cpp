// Captures go through the drivers and estimators of a rig.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "drivers/recordings/export/exporter.hpp"
#include "tests/drivers/decode/captured.hpp"
#include "tests/drivers/decode/corpora.hpp"
#include "tests/hil/replay/recorded_run.hpp"

namespace captures_for_rig_test {

using namespace recorded_run;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

constexpr const char* golden_pd0 = DRYDOCK_SOURCE_DIR "/fixtures/pd0/golden.pd0";

std::string device(const std::string& name, const std::string& kind, const std::string& protocol,
                   const std::string& link) {
  return "[[device]]\nname = \"" + name + "\"\nkind = \"" + kind + "\"\nprotocol = \"" + protocol +
         "\"\nlink = \"" + link + "\"\nrate_hz = 10\n";
}
const std::string leveling =
    "[[estimator]]\nname = \"leveling\"\nkind = \"leveling\"\nimu = \"imu\"\n"
    "model = \"stationary\"\nlatitude_deg = 36\n";

/// A rig file of these blocks, and its captures: FILE or NAME=FILE.
class Bench {
 public:
  explicit Bench(const std::string& blocks) {
    options_.rig = (folder_ / "rig.toml").string();
    fs::create_directories(folder_);
    std::ofstream(options_.rig) << "[rig]\nname = \"other\"\n" << blocks;
  }
  ~Bench() { fs::remove_all(folder_); }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  std::string file(const std::string& name, const std::string& text) const {
    const auto path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  Replayed reads(const std::vector<RigCaptures::File>& files) {
    options_.captures.files = files;
    return replayed(options_);
  }
  RigReplayOptions& options() { return options_; }

 private:
  fs::path folder_ = fs::temp_directory_path() / ("rig-captures-" + std::to_string(::getpid()));
  RigReplayOptions options_;
};

std::vector<json> of_device(const Replayed& result, const std::string& name) {
  auto lines = lines_of(result.out);
  std::erase_if(lines, [&](const json& line) { return line.value("device", "") != name; });
  return lines;
}

/// What `replay CAPTURE` makes of it alone, as a device of this name on a line of this rate.
std::vector<json> alone(const std::string& capture, const std::string& protocol,
                        const std::string& name, unsigned baud) {
  decode::ReplayOptions options;
  options.capture = capture;
  options.protocol = protocol;
  options.kind = protocol == "nmea0183" ? "gnss" : "";
  options.baud = baud;
  decode::MemoryFile out, err;
  EXPECT_EQ(decode::replay(options, out.file(), err.file()), 0) << err.text();
  auto lines = lines_of(out.text());
  for (auto& line : lines) line["device"] = name;
  return lines;
}

/// The ensembles of golden.pd0 are packed by a Python script from the maker's tables.
TEST(ACaptureForARig, GivesTheValuesAndTimesThatItsDriverMakesOfItAlone) {
  Bench bench(device("log", "dvl", "pd0", "serial:/dev/ttyUSB9?baud=115200"));
  const auto result = bench.reads({{golden_pd0}});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const auto lines = of_device(result, "log");
  EXPECT_EQ(lines, alone(golden_pd0, "pd0", "log", 115200));
  EXPECT_FALSE(lines.empty());
  EXPECT_THAT(result.err, HasSubstr("golden.pd0 ("));
  EXPECT_THAT(result.err, HasSubstr("bytes): read by log"));
}

TEST(ACaptureForARig, ThatNobodyReadsIsCountedByName) {
  Bench bench(device("log", "dvl", "pd0", "serial:/dev/ttyUSB9?baud=115200") +
              device("imu", "imu", "aceinna", "socketcan:can7") + leveling);
  const auto noise = bench.file("noise.txt", "nothing\n");
  const auto result = bench.reads({{golden_pd0}, {noise}});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("noise.txt (8 bytes): no device of this rig reads it"));
  EXPECT_THAT(result.err, HasSubstr("imu: left out, no capture has measurements of it"));
  EXPECT_THAT(result.err, HasSubstr("leveling: left out, it needs a device that is left out"));
}

/// A finding too: the line of noise has no message.
TEST(ACaptureForARig, IsToldOnceWhatFitsAndWhatDoesNotAlsoWithAReport) {
  Bench bench(device("log", "dvl", "pd0", "serial:/dev/ttyUSB9?baud=115200") +
              device("imu", "imu", "aceinna", "socketcan:can7") + leveling);
  const auto noise = bench.file("noise.txt", std::string(3000, 'x'));
  bench.options().quiet = true;
  bench.options().report = fs::path(bench.options().rig).replace_filename("out").string();
  const auto result = bench.reads({{golden_pd0}, {noise}});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  std::map<std::string, int> times;
  std::istringstream all(result.err + result.out);
  for (std::string line; std::getline(all, line);) ++times[line];
  for (const auto& [line, count] : times) EXPECT_EQ(count, 1) << line;
  EXPECT_EQ(times.count("imu: left out, no capture has measurements of it"), 1u);
}

TEST(ACaptureForARig, ThatFitsNoDeviceIsRefused) {
  Bench bench(device("imu", "imu", "aceinna", "socketcan:can7"));
  const auto result = bench.reads({{golden_pd0}});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("no device of"));
}

TEST(ACaptureForARig, OfOneOfTwoEqualDevicesNeedsItsName) {
  Bench bench(device("left", "dvl", "pd0", "serial:/dev/ttyUSB8?baud=9600") +
              device("right", "dvl", "pd0", "serial:/dev/ttyUSB9?baud=9600"));
  const auto either = bench.reads({{golden_pd0}});
  EXPECT_EQ(either.exit_code, 2);
  EXPECT_THAT(either.err, HasSubstr("left and right (pd0) may both have made"));
  const auto named = bench.reads({{golden_pd0, "right"}});
  EXPECT_EQ(named.exit_code, 0) << named.err;
  EXPECT_TRUE(of_device(named, "left").empty());
  EXPECT_EQ(of_device(named, "right"), alone(golden_pd0, "pd0", "right", 9600));
  EXPECT_THAT(bench.reads({{golden_pd0, "middle"}}).err, HasSubstr("allowed: left, right"));
}

TEST(ACaptureForARig, NamedForADeviceOnABusMustBeABus) {
  Bench bench(device("imu", "imu", "aceinna", "socketcan:can7"));
  const auto result = bench.reads({{golden_pd0, "imu"}});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("imu: aceinna is read from a CAN bus, and there is none in"));
}

class CapturesOfOthers : public decode::corpora::Corpora {};

/// aceinna_mtlt_real.expected.jsonl has what the maker's formula says of each frame.
TEST_F(CapturesOfOthers, OfABusAndOfALineFeedTheDevicesAndTheEstimatorOfARig) {
  Bench bench(device("imu", "imu", "aceinna", "socketcan:can7") +
              device("gnss", "gnss", "nmea0183", "serial:/dev/ttyUSB9?baud=4800") + leveling);
  const auto bus = (root_ / "can_imu/aceinna_mtlt_real.candump.log").string();
  const auto line = (root_ / "gps/gpsd/daemon/ait250.log").string();
  const auto result = bench.reads({{bus}, {line}});
  EXPECT_EQ(result.exit_code, 0) << result.err;

  std::vector<json> forces;
  std::ifstream expected(root_ / "can_imu/aceinna_mtlt_real.expected.jsonl");
  for (std::string row; std::getline(expected, row);)
    if (const auto frame = json::parse(row); frame.at("pgn") == 61485)
      forces.push_back(frame.at("acc_ms2"));
  const auto samples = of_device(result, "imu");
  ASSERT_GE(samples.size(), 4u);
  for (std::size_t i = 0; i < samples.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(samples[i].at("specific_force_mps2").at(axis), forces.at(i).at(axis), 1e-9);
  EXPECT_NEAR(samples[0].at("received_at_s"), 1623858970.167385, 1e-6) << "as candump stamped it";

  // The last sentence of ait250.log, in degrees and minutes: 5241.99812 N, 00517.56549 E.
  const auto fixes = of_device(result, "gnss");
  EXPECT_EQ(fixes.size(), alone(line, "nmea0183", "gnss", 4800).size());
  EXPECT_NEAR(fixes.back().at("latitude_deg"), 52 + 41.99812 / 60, 1e-9);
  EXPECT_NEAR(fixes.back().at("longitude_deg"), 5 + 17.56549 / 60, 1e-9);

  const auto all = lines_of(result.out);
  EXPECT_EQ(std::ranges::count_if(all, [](const json& l) { return l.contains("estimator"); }),
            static_cast<std::ptrdiff_t>(samples.size()));
  EXPECT_THAT(result.err, Not(HasSubstr("finding imu: silent"))) << "its capture has ended";
}

/// A yacht's log: 1457 sentences $SDHDG and 150 $SDVHW beside its receiver, says grep.
TEST_F(CapturesOfOthers, HaveSensorsThatNoDeviceReads) {
  Bench bench(device("gnss", "gnss", "nmea0183", "serial:/dev/ttyUSB9?baud=4800"));
  const auto result = bench.reads({{(root_ / "gps/gpsd/daemon/bundg_zeus_9.log").string()}});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("attitude of nmea0183, 1457 measurements: no device of this"));
  EXPECT_THAT(result.err, HasSubstr("emlog of nmea0183, 150 measurements: no device of this"));
}

/// The lines and buses of a run, with their times, in one pcapng file.
class AllLinksInOneCapture : public ReplayOfARun {
 protected:
  void SetUp() override {
    ASSERT_TRUE(exporting::export_recording(file("run.mcap"), {}, exporting::Format::pcapng,
                                            {file("run.pcapng"), true},
                                            [](double) { return true; }));
  }
};

TEST_F(AllLinksInOneCapture, GiveTheEstimatesOfTheRun) {
  RigReplayOptions options;
  options.rig = DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml";
  options.captures.files = {{file("run.pcapng")}};
  const auto captured = replayed(options);
  EXPECT_EQ(captured.exit_code, 0) << captured.err;
  RigReplayOptions recording;
  recording.recording = file("run.mcap");
  const auto recorded = replayed(recording);
  const auto values = [](const Replayed& result, const char* key, const char* name) {
    auto lines = lines_of(result.out);
    std::erase_if(lines, [&](const json& line) { return line.value(key, "") != name; });
    return lines;
  };
  for (const char* name : {"dvl", "emlog", "gnss", "imu"})
    EXPECT_EQ(values(captured, "device", name), values(recorded, "device", name)) << name;
  const auto estimates = values(captured, "estimator", "leveling");
  EXPECT_GT(estimates.size(), 1900u);
  EXPECT_EQ(estimates, values(recorded, "estimator", "leveling"));
}

/// Two halves of the run, as a logger writes that begins a new file.
class TwoCapturesInARow : public ReplayOfARun {
 protected:
  static std::string half(bool second, exporting::Format format, const std::string& name) {
    record::Selection part;
    (second ? part.from : part.to) = std::chrono::seconds{10};
    EXPECT_TRUE(exporting::export_recording(file("run.mcap"), part, format, {file(name), true},
                                            [](double) { return true; }));
    return file(name);
  }
  static Replayed of_demo(std::vector<RigCaptures::File> files) {
    RigReplayOptions options;
    options.rig = DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml";
    options.captures.files = std::move(files);
    return replayed(options);
  }
};

TEST_F(TwoCapturesInARow, OfPacketsInOneFolderGiveWhatOneFileGives) {
  using enum exporting::Format;
  const auto a = half(false, pcapng, "a.pcapng"), b = half(true, pcapng, "b.pcapng");
  ASSERT_TRUE(exporting::export_recording(file("run.mcap"), {}, pcapng, {file("run.pcapng"), true},
                                          [](double) { return true; }));
  const auto folder = folder_.string();
  const auto joined = of_demo({{b, "", folder}, {a, "", folder}});
  EXPECT_EQ(joined.exit_code, 0) << joined.err;
  EXPECT_THAT(joined.err, HasSubstr("read as one, in the order of their times"));
  for (const char* name : {"dvl", "emlog", "gnss", "imu"})
    EXPECT_EQ(of_device(joined, name), of_device(of_demo({{file("run.pcapng")}}), name)) << name;
}

TEST_F(TwoCapturesInARow, OfABusGiveWhatOneFileGives) {
  using enum exporting::Format;
  const auto a = half(false, candump, "a.log"), b = half(true, candump, "b.log");
  ASSERT_TRUE(exporting::export_recording(file("run.mcap"), {}, candump, {file("run.log"), true},
                                          [](double) { return true; }));
  const auto joined = of_demo({{b, "imu"}, {a, "imu"}});
  EXPECT_EQ(joined.exit_code, 0) << joined.err;
  const auto samples = of_device(joined, "imu");
  EXPECT_GT(samples.size(), 1900u);
  EXPECT_EQ(samples, of_device(of_demo({{file("run.log"), "imu"}}), "imu"));
}

TEST_F(AllLinksInOneCapture, AreJudgedWithoutATruth) {
  RigReplayOptions options;
  options.rig = DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml";
  options.recording = "run.pcapng";
  options.captures.files = {{file("run.pcapng")}};
  options.json = file("captured.json");
  options.quiet = true;
  const auto result = replayed(options);
  EXPECT_EQ(result.exit_code, 1) << "the demo rig expects an attitude near to the truth";
  std::ifstream in(options.json);
  const auto summary = json::parse(in);
  EXPECT_THAT(summary.at("notes").dump(), HasSubstr("run.pcapng, which has no truth"));
  EXPECT_THAT(summary.at("notes").dump(), HasSubstr("read by imu, depth, actuators"));
  EXPECT_EQ(summary.at("devices").size(), 6u);
}

}  // namespace captures_for_rig_test
