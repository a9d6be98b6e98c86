#include <gmock/gmock.h>

#include <numbers>

#include "rig_config/load.hpp"

/// Sensor files: each figure in SI, calculated by hand from the tables of their sources.
namespace drydock::rig_config {
namespace sensor_file_test {

using std::numbers::pi;
const std::string folder = DRYDOCK_SOURCE_DIR "/rig_config/";

EmulateConfig grade(const std::string& name, DeviceKind kind) {
  return load_sensor(folder + "sensors/" + name, kind).value();
}

void expect_all(const Axes& figures, double expected) {
  for (const double figure : figures) EXPECT_NEAR(figure, expected, 1e-9 * expected);
}

TEST(SensorFile, HoldsTheMixingPapersTable5) {
  const auto imu = grade("mixing-paper.toml", DeviceKind::imu);
  EXPECT_FALSE(imu.fixed_bias);
  EXPECT_EQ(imu.rate_hz, 100);
  expect_all(imu.primary.bias, 4.84813681109536e-5);              // 10 deg/h
  expect_all(imu.primary.sensitivity, 2.471861854504525e-6);      // 5 deg/h/g
  expect_all(imu.primary.anisoelasticity, 5.041195218559906e-8);  // 1 deg/h/g^2
  expect_all(imu.primary.scale_factor, 6e-4);
  expect_all(imu.primary.asymmetry, 1e-4);
  expect_all(imu.primary.nonlinearity, 1.145915590261646e-4);  // 2e-6 per deg/s
  expect_all(imu.primary.misalignment, 1e-3);
  expect_all(imu.primary.noise, 4.363323129985824e-3);              // 0.25 deg/s
  expect_all(imu.secondary.bias, 1.96133e-2);                       // 2e-3 g
  expect_all(imu.secondary.sensitivity, 5.618796561619687e-2);      // 1e-4 g per deg/s
  expect_all(imu.secondary.anisoelasticity, 3.059148638933785e-6);  // 3e-5 g/g^2
  expect_all(imu.secondary.nonlinearity, 7.647871597334462e-7);     // 7.5e-6 g/g^2
  expect_all(imu.secondary.noise, 1.96133e-4);                      // 2e-5 g
  const auto log = grade("mixing-paper.toml", DeviceKind::emlog);
  EXPECT_EQ(log.primary.scale_factor, (Axes{0.02, 0, 0}));
}

TEST(SensorFile, HoldsTheVelocityFilterPapersTable2) {
  const auto imu = grade("velocity-filter-paper.toml", DeviceKind::imu);
  EXPECT_EQ(imu.rate_hz, 10);
  expect_all(imu.primary.bias, 9.69627362219072e-9);             // 2 mdeg/h
  expect_all(imu.primary.noise_density, 1.1635528346628864e-7);  // 0.4 mdeg/sqrt(h)
  expect_all(imu.secondary.bias, 3.92266e-5);                    // 4 ug
  expect_all(imu.secondary.noise_density, 3.92266e-5);           // 4 ug/sqrt(Hz)
  expect_all(imu.primary.scale_factor, 3e-7);
  expect_all(imu.secondary.scale_factor, 3e-7);
  const auto depth = grade("velocity-filter-paper.toml", DeviceKind::depth);
  EXPECT_NEAR(depth.primary.noise[0] / (1025 * 9.80665), 0.5, 1e-4);
  EXPECT_EQ(depth.rate_hz, 100);
  EXPECT_EQ(grade("velocity-filter-paper.toml", DeviceKind::dvl).rate_hz, 1);
  EXPECT_EQ(grade("velocity-filter-paper.toml", DeviceKind::emlog).rate_hz, 2);
}

TEST(SensorFile, ConvertsDataSheetUnits) {
  const auto imu = grade("xsens-mti-630.toml", DeviceKind::imu);
  expect_all(imu.primary.noise_density, 0.007 * pi / 180);  // deg/s/sqrt(Hz)
  expect_all(imu.primary.range, 34.906585039886586);
  EXPECT_NEAR(imu.secondary.bias_instability[2], 15e-6 * 9.80665, 1e-15);
  EXPECT_EQ(imu.primary.correlation_s, 600);
}

TEST(SensorFile, WithoutATableForTheKindIsRefused) {
  const auto refused = load_sensor(folder + "sensors/water-linked-a50.toml", DeviceKind::imu);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().at(0).what, testing::HasSubstr("has no table [imu]"));
}

std::string rig_with(const std::string& device) {
  return "[rig]\nname = \"r\"\n[[device]]\nname = \"d\"\n" + device;
}

TEST(SensorFile, ItsRateHoldsWhereTheDeviceNamesNone) {
  const std::string dvl =
      "kind = \"dvl\"\nprotocol = \"pd0\"\nlink = \"pty:d\"\n"
      "emulate = { errors = \"../sensors/velocity-filter-paper.toml\", dropout_probability = 0.1, "
      "dropout_mean_samples = 4, velocity_quantisation_mps = 0.001, latency_ms = 5 }\n";
  const std::string path = folder + "rigs/r.toml";
  const auto graded = load_rig_text(rig_with(dvl), path).value().devices.at(0);
  EXPECT_EQ(graded.rate_hz, 1);
  expect_all(graded.emulate.primary.noise, 0.03);
  EXPECT_EQ(graded.emulate.dropout.probability, 0.1);
  EXPECT_EQ(graded.emulate.dropout.mean_samples, 4);
  EXPECT_EQ(graded.emulate.latency_s, 0.005);
  expect_all(graded.emulate.primary.quantisation, 0.001);
  EXPECT_EQ(load_rig_text(rig_with("rate_hz = 5\n" + dvl), path).value().devices.at(0).rate_hz, 5);
}

TEST(SensorFile, ItsPowerNoiseHoldsWhereTheSkyNamesNone) {
  const auto noise = [](const std::string& key) {
    return load_rig_text(rig_with("kind = \"gnss\"\nprotocol = \"ubx\"\nlink = \"pty:d\"\n"
                                  "[device.emulate]\nerrors = \"../sensors/gps-roll-paper.toml\"\n"
                                  "[device.emulate.sky]\nephemeris = "
                                  "\"../../fixtures/rinex/walker.rnx\"\n" +
                                  key),
                         folder + "rigs/r.toml")
        .value()
        .devices.at(0)
        .emulate.sky->power_noise;
  };
  EXPECT_EQ(noise(""), 0.1);
  EXPECT_EQ(noise("power_noise = 0.02\n"), 0.02);
}

}  // namespace sensor_file_test
}  // namespace drydock::rig_config
