#include "hil/track/track.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "drivers/recordings/record/recording.hpp"
#include "hil/bench/run.hpp"
#include "rig_config/load.hpp"

namespace drydock::track {
namespace {

namespace fs = std::filesystem;

/// 60 s of the demo rig in virtual time: DVL with its own attitude, log, depth, and fixes until the
/// vehicle dives after 45 s.
class TrackOfARun : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = fs::temp_directory_path() / ("track-test-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    const auto rig = rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
    bench::RunOptions options;
    options.duration_s = 60;
    options.quiet = true;
    options.record.path = recording();
    bench::run_lockstep(rig, options);
  }
  static void TearDownTestSuite() { fs::remove_all(folder_); }

  static std::string recording() { return (folder_ / "dive.mcap").string(); }
  static std::string file(const std::string& name) { return (folder_ / name).string(); }

  /// The exit code, and what was printed on both streams together.
  static std::pair<int, std::string> run(TrackOptions options) {
    if (options.source.capture.empty()) options.source.capture = recording();
    testing::internal::CaptureStdout();
    const int code = track(options, stdout, stdout);
    std::fflush(stdout);
    return {code, testing::internal::GetCapturedStdout()};
  }

  static inline fs::path folder_;
};

TEST_F(TrackOfARun, IsBetterThanItsFixesAndSaysSoAgainstTheTruth) {
  TrackOptions options;
  options.json = true;
  const auto [code, text] = run(options);
  ASSERT_EQ(code, 0) << text;
  const auto json = nlohmann::json::parse(text);
  EXPECT_EQ(json["model"], "level");
  EXPECT_NEAR(json["duration_s"], 60, 1.5);
  EXPECT_NEAR(json["distance_m"], 3.0 * 60, 12);  // 3 m/s in the mission file, and a current
  EXPECT_GT(json["truth"]["points"], 500);
  EXPECT_LT(json["truth"]["smoother_rms_m"], 1.0);  // the rig's fixes: 1.5 m an axis
  EXPECT_LT(json["truth"]["smoother_rms_m"], json["truth"]["filter_rms_m"]);
  EXPECT_GT(json["passed_over"]["GNSS without fix"], 10);
}

TEST_F(TrackOfARun, TheFittedNoiseIsAboutThatOfTheRigFile) {
  TrackOptions options;
  options.json = true;
  const auto json = nlohmann::json::parse(run(options).second);
  for (const auto& sensor : json["sensors"]) {
    if (sensor["quantity"] != "bottom track") continue;
    EXPECT_TRUE(sensor["sigma_fitted"]);
    EXPECT_GT(sensor["sigma"], 0.008);  // velocity_noise_mps is 0.01; the path turns all the time
    EXPECT_LT(sensor["sigma"], 0.015);
    EXPECT_EQ(sensor["unused"], 0);
  }
}

TEST_F(TrackOfARun, WritesEachFormatByTheEndOfItsName) {
  for (const char* name : {"dive.geojson", "dive.gpx", "dive.csv", "track.mcap"}) {
    TrackOptions options;
    options.out = file(name);
    EXPECT_EQ(run(options).first, 0) << name;
    EXPECT_GT(fs::file_size(options.out), 1000U) << name;
    EXPECT_EQ(run(options).first, 1) << name << " must not be replaced";
  }
  auto written = record::Recording::open(file("track.mcap")).value();
  int smoothed = 0, filtered = 0;
  while (const auto event = written.next())
    if (const auto* message = std::get_if<record::Understood>(&*event)) {
      smoothed += message->channel->topic == "/estimate/smoothed/odometry" ? 1 : 0;
      filtered += message->channel->topic == "/estimate/filtered/odometry" ? 1 : 0;
    }
  EXPECT_GT(smoothed, 500);
  EXPECT_EQ(smoothed, filtered);
}

TEST_F(TrackOfARun, ItsReportHasAMapAndTheResidualsOfEverySensor) {
  TrackOptions options;
  options.report = file("report");
  ASSERT_EQ(run(options).first, 0);
  std::ifstream in(fs::path(options.report) / "index.html");
  const std::string page(std::istreambuf_iterator<char>(in), {});
  for (const char* text :
       {"Map", "dvl: residuals of bottom track", "emlog: residuals of log",
        "depth: residuals of depth", "gnss: residuals of fix", "NIS", "dvl, heading [deg]"})
    EXPECT_NE(page.find(text), std::string::npos) << text;
}

TEST_F(TrackOfARun, ACaptureWithoutAMeasurementSaysWhatToLookAt) {
  TrackOptions options;
  options.source.capture = DRYDOCK_SOURCE_DIR "/README.md";
  options.source.protocol = "pd0";
  const auto [code, text] = run(options);
  EXPECT_EQ(code, 1);
  EXPECT_NE(text.find("the driver of pd0 made no measurement of it; `drydock info`"),
            std::string::npos)
      << text;
  options.source.capture = file("empty.pd0");
  std::ofstream(options.source.capture).close();
  EXPECT_NE(run(options).second.find("is empty"), std::string::npos);
}

TEST_F(TrackOfARun, OfGnssAloneIsTheAntennasWayWithoutAHeading) {
  TrackOptions options;
  options.part.only = {"gnss"};
  const auto [code, text] = run(options);
  EXPECT_EQ(code, 0) << text;
  EXPECT_NE(text.find("its heading is not known"), std::string::npos) << text;
}

/// RMC tells the date; the clock of the capture is a time of day.
TEST_F(TrackOfARun, OfAReceiverHasTheUtcThatItTells) {
  TrackOptions options;
  options.source.capture = file("rmc.nmea");
  options.source.protocol = "nmea0183";
  options.source.kind = "gnss";
  std::ofstream(options.source.capture)
      << "$GPRMC,235950.00,A,4130.0,N,07042.0,W,3.9,0.0,020324,,,A*4E\r\n"
         "$GPRMC,235951.00,A,4130.0,N,07042.0,W,3.9,0.0,020324,,,A*4F\r\n"
         "$GPRMC,235952.00,A,4130.0,N,07042.0,W,3.9,0.0,020324,,,A*4C\r\n"
         "$GPRMC,235953.00,A,4130.0,N,07042.0,W,3.9,0.0,020324,,,A*4D\r\n"
         "$GPRMC,235954.00,A,4130.0,N,07042.0,W,3.9,0.0,020324,,,A*4A\r\n"
         "$GPRMC,235955.00,A,4130.0,N,07042.0,W,3.9,0.0,020324,,,A*4B\r\n"
         "$GPRMC,235956.00,A,4130.0,N,07042.0,W,3.9,0.0,020324,,,A*48\r\n"
         "$GPRMC,235957.00,A,4130.0,N,07042.0,W,3.9,0.0,020324,,,A*49\r\n";
  options.out = file("rmc.gpx");
  const auto [code, text] = run(options);
  ASSERT_EQ(code, 0) << text;
  std::ifstream gpx(options.out);
  const std::string written{std::istreambuf_iterator<char>(gpx), {}};
  EXPECT_NE(written.find("<time>2024-03-02T23:59:50.000Z</time>"), std::string::npos) << written;
}

std::string content_of(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// 425.0 and 425.1 m above the sea, and the geoid 41.7 m above the ellipsoid: 466.7 and 466.8 m.
TEST_F(TrackOfARun, OfAReceiverHasItsHeightAboveTheEllipsoid) {
  TrackOptions options;
  options.source.capture = file("gga.nmea");
  options.source.protocol = "nmea0183";
  options.source.kind = "gnss";
  std::ofstream(options.source.capture)
      << "$GPGGA,100000.00,5230.0000,N,01320.0000,E,4,12,0.8,425.0,M,41.7,M,,*66\r\n"
         "$GPGGA,100001.00,5230.0000,N,01320.0000,E,4,12,0.8,425.1,M,41.7,M,,*66\r\n"
         "$GPGGA,100002.00,5230.0000,N,01320.0000,E,4,12,0.8,425.0,M,41.7,M,,*64\r\n"
         "$GPGGA,100003.00,5230.0000,N,01320.0000,E,4,12,0.8,425.1,M,41.7,M,,*64\r\n"
         "$GPGGA,100004.00,5230.0000,N,01320.0000,E,4,12,0.8,425.0,M,41.7,M,,*62\r\n"
         "$GPGGA,100005.00,5230.0000,N,01320.0000,E,4,12,0.8,425.1,M,41.7,M,,*62\r\n"
         "$GPGGA,100006.00,5230.0000,N,01320.0000,E,4,12,0.8,425.0,M,41.7,M,,*60\r\n"
         "$GPGGA,100007.00,5230.0000,N,01320.0000,E,4,12,0.8,425.1,M,41.7,M,,*60\r\n";
  options.out = file("gga.csv");
  const auto [code, text] = run(options);
  ASSERT_EQ(code, 0) << text;
  std::istringstream csv(content_of(options.out));
  std::string line;
  std::getline(csv, line);
  int points = 0;
  for (; std::getline(csv, line); ++points) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    EXPECT_NEAR(std::stod(cells.at(4)), 466.75, 0.2) << line;
    EXPECT_LT(std::stod(cells.at(13)), 5) << "the sigma of the receiver's height, not of none";
  }
  EXPECT_GE(points, 7);
}

/// RMC tells no height.
TEST_F(TrackOfARun, WithoutAHeightHasNone) {
  TrackOptions options;
  options.source.capture = file("flat.nmea");
  options.source.protocol = "nmea0183";
  options.source.kind = "gnss";
  std::ofstream(options.source.capture)
      << "$GPRMC,235950.00,A,4130.0,N,07042.0,W,3.9,0.0,020324,,,A*4E\r\n"
         "$GPRMC,235951.00,A,4130.0,N,07042.0,W,3.9,0.0,020324,,,A*4F\r\n"
         "$GPRMC,235952.00,A,4130.0,N,07042.0,W,3.9,0.0,020324,,,A*4C\r\n"
         "$GPRMC,235953.00,A,4130.0,N,07042.0,W,3.9,0.0,020324,,,A*4D\r\n";
  options.out = file("flat.gpx");
  const auto [code, text] = run(options);
  ASSERT_EQ(code, 0) << text;
  EXPECT_NE(text.find("nothing tells the height"), std::string::npos) << text;
  EXPECT_EQ(content_of(options.out).find("<ele>"), std::string::npos);
}

TEST_F(TrackOfARun, SaysWhyThereIsNoTrack) {
  TrackOptions options;
  options.part.only = {"depth"};
  const auto [code, text] = run(options);
  EXPECT_EQ(code, 1);
  EXPECT_NE(text.find("no heading"), std::string::npos) << text;
  options = {};
  options.model = Model::inertial;
  EXPECT_NE(run(options).second.find("estimator of kind navigation"), std::string::npos);
  options = {};
  options.out = file("dive.kml");
  EXPECT_EQ(run(options).first, 2);
  options = {};
  options.source.capture = DRYDOCK_SOURCE_DIR "/README.md";
  EXPECT_EQ(run(options).first, 2);
}

}  // namespace
}  // namespace drydock::track
