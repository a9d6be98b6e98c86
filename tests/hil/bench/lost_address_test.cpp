// A J1939 sensor loses its address while its driver hears nothing. When the bus is back, the driver
// finds the sensor by its NAME at the new address.
#include <gmock/gmock.h>

#include <utility>
#include <vector>

#include "hil/bench/run.hpp"
#include "rig_config/load.hpp"
#include "tests/hil/bench/each_measurement.hpp"
#include "tests/test_name.hpp"

namespace lost_address_test {
namespace {

using namespace drydock;

/// The times at which messages of a device arrived, seconds from the start.
std::vector<double> arrivals(const std::string& faults, std::string_view device,
                             bool with_address = true) {
  auto rig = rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/soak.toml").value();
  for (auto& one : rig.devices)
    if (!with_address && one.name == device) one.address = 0;
  rig.faults = rig_config::load_faults_text(faults, "test").value();
  EXPECT_THAT(rig_config::check_faults_of(rig), ::testing::IsEmpty());
  std::vector<double> at_s;
  bench::RunOptions options;
  options.duration_s = 60;
  options.quiet = true;
  bench::EachMeasurement each([&](const measurement::Measurement& m) {
    const auto& origin = measurement::origin_of(m);
    const auto start = measurement::stamp_from_ns(rig.start_utc_ns);
    if (rig.devices.at(origin.device).name == device)
      at_s.push_back(measurement::seconds(origin.received_at - start));
  });
  options.followers = {&each};
  bench::run_lockstep(rig, options);
  return at_s;
}

/// The longest silence between two messages: the times of its beginning and end.
std::pair<double, double> longest_silence(const std::vector<double>& at_s) {
  std::pair<double, double> longest{0, 0};
  for (std::size_t i = 1; i < at_s.size(); ++i)
    if (at_s[i] - at_s[i - 1] > longest.second - longest.first) longest = {at_s[i - 1], at_s[i]};
  return longest;
}

class EachSensor : public ::testing::TestWithParam<const char*> {};

TEST_P(EachSensor, IsFoundAgainWhoseAddressWasTakenWhileTheDriverWasBusOff) {
  const std::string name = GetParam();
  const std::string other = name == "depth" ? "actuators" : "depth";
  const auto at_s =
      arrivals("[[fault]]\ndevice = \"" + other +
                   "\"\nfault = \"bus-off\"\nstart_s = 20\nfor_s = 8\n[[fault]]\ndevice = \"" +
                   name + "\"\nfault = \"address-stolen\"\nstart_s = 25\nfor_s = 60\n",
               name);
  ASSERT_GT(at_s.size(), 90u);
  const auto [from_s, to_s] = longest_silence(at_s);
  EXPECT_NEAR(from_s, 20, 0.51) << "of 2 Hz";
  EXPECT_NEAR(to_s, from_s + 10, 0.51) << "asked for when it was silent for 10 s";
  EXPECT_GT(at_s.back(), 59);
}

TEST_P(EachSensor, IsFollowedAtOnceIfTheRigStatesNoAddress) {
  const std::string name = GetParam();
  const auto at_s = arrivals("[[fault]]\ndevice = \"" + name +
                                 "\"\nfault = \"address-stolen\"\nstart_s = 20\nfor_s = 60\n",
                             name, false);
  ASSERT_GT(at_s.size(), 90u);
  const auto [from_s, to_s] = longest_silence(at_s);
  EXPECT_LT(to_s - from_s, 1.1) << "of 2 Hz; while it claims, for 250 ms, it is silent";
  EXPECT_GT(at_s.back(), 59);
}

INSTANTIATE_TEST_SUITE_P(J1939, EachSensor, ::testing::Values("depth", "actuators", "openimu"),
                         [](const auto& one) { return drydock::test::test_name(one.param); });

TEST(BusOff, EndsWhenTheLastFaultThatKeepsTheControllerOffHasCleared) {
  const auto at_s = arrivals(
      "[[fault]]\ndevice = \"depth\"\nfault = \"bus-off\"\nstart_s = 20\nfor_s = 30\n"
      "[[fault]]\ndevice = \"actuators\"\nfault = \"bus-off\"\nstart_s = 25\nfor_s = 5\n",
      "openimu");
  const auto [from_s, to_s] = longest_silence(at_s);
  EXPECT_NEAR(from_s, 20, 0.51);
  EXPECT_NEAR(to_s, 50, 0.51);
}

}  // namespace
}  // namespace lost_address_test
