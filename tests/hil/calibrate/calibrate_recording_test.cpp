#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "hil/bench/run.hpp"
#include "hil/calibrate/calibrate.hpp"
#include "rig_config/load.hpp"

namespace drydock::calibrate {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

constexpr const char* compass = R"(
[[device]]
name = "compass"
kind = "attitude"
protocol = "nmea2000"
link = "can:auto?name=drydock0&bitrate=250000"
rate_hz = 5
address = 37
)";

/// 75 s of the demo rig with a compass, at the surface and below. Then the rig says that its DVL
/// stands at 43 degrees, where the emulated one stands at 45.
class CalibrationOfARun : public testing::Test {
 protected:
  CalibrationOfARun() {
    fs::create_directories(folder_ / "rigs");
    for (const char* part : {"missions", "sensors"})
      fs::copy(fs::path(DRYDOCK_SOURCE_DIR) / "rig_config" / part, folder_ / part);
    const auto demo = text_of(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml") + compass;
    const auto at = demo.find("[0.0, 0.0, 45.0]");
    std::ofstream(file("true.toml")) << demo;
    std::ofstream(file("wrong.toml"))
        << demo.substr(0, at) << "[0.0, 0.0, 43.0]" << demo.substr(at + 16);
    bench::RunOptions options;
    options.duration_s = 75;
    options.quiet = true;
    options.record.path = file("dive.mcap");
    bench::run_lockstep(rig_config::load_rig(file("true.toml")).value(), options);
  }
  ~CalibrationOfARun() override { fs::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / "rigs" / name).string(); }

  const fs::path folder_ =
      fs::temp_directory_path() / ("calibrate-test-" + std::to_string(::getpid()));
};

TEST_F(CalibrationOfARun, FindsTwoDegreesOfYawAndWritesThemIntoTheRigFile) {
  CalibrateOptions options;
  options.source.source.capture = file("dive.mcap");
  options.source.rig = file("wrong.toml");
  options.source.part.only = {"dvl", "gnss", "depth", "compass"};  // the log has a constant bias
  options.write = file("right.toml");
  options.report = file("report");
  options.json = true;
  testing::internal::CaptureStdout();
  const int code = calibrate(options, stdout, stderr);
  std::fflush(stdout);
  const auto json = nlohmann::json::parse(testing::internal::GetCapturedStdout());
  ASSERT_EQ(code, 0);
  const auto& yaw = json["findings"][0];
  ASSERT_EQ(yaw["parameter"], "yaw");
  EXPECT_EQ(yaw["verdict"], "told");
  const auto right = rig_config::load_rig(options.write);
  ASSERT_TRUE(right) << right.error().front().what;
  const auto& mounting = right->devices[0].mounting_rad;
  EXPECT_NEAR(mounting[2], 45 * M_PI / 180, yaw["bound_95"].get<double>());
  EXPECT_LT(yaw["bound_95"], 1.5 * M_PI / 180);  // so 43 degrees are outside
  EXPECT_EQ(calibrate(options, stdout, stderr), 1) << "must not be replaced";
  ASSERT_EQ(json["residuals"].size(), 4U);
  for (const auto& residual : json["residuals"])
    if (residual["quantity"] == "fix") {
      EXPECT_LT(residual["nis_after"], residual["nis_before"]);
    }
  const auto page = text_of(file("report/index.html"));
  for (const char* part :
       {"settled after", "Correlations", "Residuals before and after", "dvl: yaw"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
}

TEST(CalibrationOfACapture, OfOneSensorAloneIsRefusedWithWhatItNeeds) {
  CalibrateOptions options;
  options.source.source.capture = DRYDOCK_SOURCE_DIR "/fixtures/pd0/golden.pd0";
  options.source.source.protocol = "pd0";
  testing::internal::CaptureStdout();
  EXPECT_EQ(calibrate(options, stdout, stdout), 1);
  std::fflush(stdout);
  EXPECT_NE(testing::internal::GetCapturedStdout().find("one sensor alone"), std::string::npos);
}

}  // namespace
}  // namespace drydock::calibrate
