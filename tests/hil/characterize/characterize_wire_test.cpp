// The known errors of an emulated sensor are found again: through its wire, its driver and an hour
// of virtual time, and from a recording.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

#include "drivers/host/rig_bus.hpp"
#include "drivers/recordings/mcap/file_sink.hpp"
#include "drivers/recordings/record/recorder.hpp"
#include "hil/bench/run.hpp"
#include "hil/characterize/report/characterize.hpp"
#include "rig_config/load.hpp"
#include "tests/hil/bench/each_measurement.hpp"

namespace {

using namespace drydock;

constexpr double degree = std::numbers::pi / 180, micro_g = 9.80665e-6;

class Characterize : public testing::Test {
 protected:
  Characterize() {
    auto name = (std::filesystem::temp_directory_path() / "drydock-characterize-XXXXXX").string();
    folder_ = mkdtemp(name.data());
    write("rest.toml",
          "[mission]\nlatitude_deg = 36\nlongitude_deg = 129\ndepth_m = 10\nheading_deg = 0\n"
          "speed_mps = 0\n[[leg]]\nkind = \"straight\"\nduration_s = 30\n");
    write("rig.toml",
          "[rig]\nname = \"bench\"\nseed = 7\nmission = \"rest.toml\"\n"
          "start = 2026-11-21T08:00:00Z\n"
          "[[device]]\nname = \"imu\"\nkind = \"imu\"\nprotocol = \"cia404-imu\"\n"
          "link = \"memory-can:bench?bitrate=1000000\"\nrate_hz = 100\naddress = 1\n"
          "mounting_deg = [180.0, 0.0, 90.0]\n"
          "[device.emulate]\ngyro_bias_degph = [300, 0, -200]\n"
          "gyro_angle_random_walk_degprth = [0.4, 0.5, 0.6]\n"
          "gyro_bias_instability_degph = 60\ngyro_correlation_s = 20\n"
          "accelerometer_velocity_random_walk_ugprthz = 60\n"
          "accelerometer_random_walk_ugprth = 600\n"
          "dropout_probability = 0.001\ndropout_mean_samples = 3\n");
  }
  ~Characterize() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

characterize::Characterized characterized(const characterize::Gathered& gathered) {
  characterize::Characterized device{
      characterize::figures_of(gathered.devices.at(0)).value(), {}, {}};
  device.measured = characterize::grade_of(device.figures);
  return device;
}

TEST_F(Characterize, AnHourOfAnEmulatedImuGivesItsParametersBackWithinTheirBounds) {
  characterize::CharacterizeOptions options;
  options.source = path("rig.toml");
  testing::internal::CaptureStdout();
  const auto gathered = characterize::gather(options);
  testing::internal::GetCapturedStdout();
  const auto device = characterized(gathered);
  const auto& timing = device.figures.timing;
  EXPECT_NEAR(static_cast<double>(timing.samples + timing.lost), 360'000, 100);
  EXPECT_TRUE(timing.outage_probability.holds(0.001)) << timing.outage_probability.value;
  EXPECT_NEAR(timing.mean_outage, 3, 0.5);
  EXPECT_NEAR(timing.rate_hz.value, 100, 1e-4);

  const auto& gyro = device.figures.quantities.at(0);
  const auto& accelerometer = device.figures.quantities.at(1);
  EXPECT_TRUE(gyro.steady() && accelerometer.steady());
  constexpr double degph = degree / 3600;
  const double walks[] = {0.4, 0.5, 0.6};
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_TRUE(gyro.axes[i]->noise && gyro.axes[i]->noise->instability) << i;
    const auto& noise = *gyro.axes[i]->noise;
    EXPECT_TRUE(noise.density->holds(walks[i] * degree / 60)) << i;
    EXPECT_TRUE(noise.instability->holds(60 * degph))
        << i << ' ' << noise.model.instability / degph;
    EXPECT_TRUE(noise.correlation_s->holds(20)) << i << ' ' << noise.model.correlation_s;
    ASSERT_TRUE(accelerometer.axes[i]->noise && accelerometer.axes[i]->noise->walk) << i;
    const auto& force = *accelerometer.axes[i]->noise;
    EXPECT_TRUE(force.density->holds(60 * micro_g)) << i;
    EXPECT_TRUE(force.walk->holds(600 * micro_g / 60)) << i << ' ' << force.walk->value / micro_g;
  }
  // In the unit's own axes, for any mounting. The Earth's rotation is within the bounds.
  using rig_config::SensorErrors;
  const auto& low = device.measured.low.primary.bias;
  const auto& high = device.measured.high.primary.bias;
  EXPECT_LT(low[0], 300 * degph);
  EXPECT_GT(high[0], 300 * degph);
  EXPECT_LT(low[2], -200 * degph);
  EXPECT_GT(high[2], -200 * degph);

  // The written file contains the measured values, and the checker accepts it.
  write("imu.toml", characterize::sensor_file_of(device, "rig.toml"));
  EXPECT_TRUE(rig_config::check_file(path("imu.toml")).empty());
  const auto grade = rig_config::load_sensor(path("imu.toml"), rig_config::DeviceKind::imu).value();
  EXPECT_NEAR(grade.primary.noise_density[1] / device.measured.value.primary.noise_density[1], 1,
              1e-6);
  EXPECT_NEAR(grade.dropout.probability, 0.001, 0.0003);
}

TEST_F(Characterize, ARecordingGivesTheSameFiguresAsTheRunItWasMadeOf) {
  characterize::CharacterizeOptions options;
  options.source = path("rig.toml");
  options.duration_s = 60;
  const auto rig = rig_config::load_rig(options.source).value();
  record::RecorderOptions recorded;
  recorded.devices = host::bus_devices(rig);
  recorded.when_behind = record::WhenBehind::wait;
  {
    record::Recorder recorder(mcap::file_sink(path("dive.mcap")).value(), recorded);
    bench::RunOptions run;
    run.duration_s = 60;
    bench::EachMeasurement each(
        [&](const measurement::Measurement& m) { recorder.topics().publish(m); });
    run.followers = {&each};
    testing::internal::CaptureStdout();
    bench::run_lockstep(rig, run);
    testing::internal::GetCapturedStdout();
    ASSERT_FALSE(recorder.finish());
  }
  testing::internal::CaptureStdout();
  const auto live = characterize::gather(options);
  testing::internal::GetCapturedStdout();
  options.source = path("dive.mcap");
  const auto played = characterize::gather(options);
  ASSERT_EQ(played.devices.size(), 1U);
  const auto &a = live.devices[0], &b = played.devices[0];
  EXPECT_EQ(b.subject.name, "imu");
  ASSERT_EQ(a.origins.size(), b.origins.size());
  for (std::size_t i = 0; i < a.origins.size(); i += 100) {
    EXPECT_EQ(a.origins[i].received_at, b.origins[i].received_at);
    EXPECT_EQ(a.origins[i].valid_at, b.origins[i].valid_at);
    EXPECT_TRUE(
        (a.subject.sensor_to_body * a.quantities[0][i]).isApprox(b.quantities[0][i], 1e-12));
  }
}

TEST_F(Characterize, AnUnknownDeviceIsRefusedWithTheNamesThereAre) {
  characterize::CharacterizeOptions options;
  options.source = path("rig.toml");
  options.duration_s = 1;
  options.device = "dvl";
  std::FILE* errors = std::tmpfile();
  testing::internal::CaptureStdout();
  EXPECT_EQ(characterize::characterize_source(options, stdout, errors), 2);
  testing::internal::GetCapturedStdout();
  std::rewind(errors);
  char line[200] = {};
  ASSERT_NE(std::fgets(line, sizeof line, errors), nullptr);
  std::fclose(errors);
  EXPECT_STREQ(line, "characterize: no device \"dvl\"; there are: imu\n");
}

}  // namespace
