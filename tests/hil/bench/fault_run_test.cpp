// Every word of the vocabulary on an emulated rig in lockstep. The run with a fault equals the run
// without it until the fault begins, differs while it is in force, and is equal again after its
// end.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "hil/bench/run.hpp"
#include "hil/replay/replay_lines.hpp"
#include "rig_config/fault_vocabulary.hpp"
#include "rig_config/load.hpp"
#include "tests/hil/bench/each_measurement.hpp"

namespace fault_run_test {
namespace {

using namespace drydock;

constexpr double sets_s = 20, clears_s = 26, settled_s = 45, end_s = 60;

struct Case {
  std::string device, fault, more = "";
  /// The fault changes the sensor's random numbers or phase for good, so only the count of messages
  /// returns to normal.
  bool for_good = false;
};

/// A word that is not here is tried on the first device of the demo that can have it.
const Case cases[] = {
    {"depth", "off", "", true},
    {"dvl", "stuck"},
    {"gnss", "bias", "position_m = [10, 0, 0]"},
    {"depth", "drift", "pressure_pa = 20000\nwithin_s = 5"},
    {"dvl", "noise", "times = 5"},
    {"imu", "wrong", "rate_degps = [0, 0, 30]"},
    {"depth", "spike", "pressure_pa = 50000\nprobability = 0.5"},
    {"imu", "drop"},
    {"dvl", "flip"},
    {"dvl", "truncate"},
    {"gnss", "bad-checksum"},
    {"emlog", "duplicate"},
    {"imu", "reorder"},
    {"gnss", "garbage", "bytes = 4096"},
    {"dvl", "unplug"},
    {"gnss", "hang"},
    {"emlog", "wrong-baud", "baud = 9600"},
    {"dvl", "eof"},
    {"imu", "bus-off"},
    {"imu", "error-frames"},
    {"depth", "babbling"},
    {"depth", "address-stolen", "", true},
    {"imu", "bus-load", "share = 0.4"},
    {"gnss", "delay"},
    {"imu", "jitter"},
    {"dvl", "slow"},
    {"emlog", "burst"},
    {"gnss", "clock-step", "seconds = 3600"},
    {"imu", "clock-drift", "ppm = 1000", true},
    {"dvl", "bottom-lost", "", true},
    {"gnss", "satellites-blocked", "", true},
    {"gnss", "antenna-gain", "db = -12"},
};

struct Heard {
  std::vector<std::string> lines;  ///< the device's measurements with times, every digit
  std::vector<double> received_s;
  summary::DeviceSummary device;

  std::vector<std::string> between(double from_s, double to_s) const {
    std::vector<std::string> part;
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (received_s[i] >= from_s && received_s[i] < to_s) part.push_back(lines[i]);
    return part;
  }
};

/// The demo's sensors at the surface, where a GNSS receiver has satellites.
rig_config::Rig rig_at_the_surface() {
  auto rig = rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml").value();
  std::erase_if(rig.mission.legs,
                [](const auto& leg) { return leg.kind == rig_config::LegKind::dive; });
  rig.expects.clear();
  return rig;
}

std::string text_of(const rig_config::Rig& rig, const measurement::Measurement& m) {
  char* text = nullptr;
  std::size_t size = 0;
  std::FILE* memory = ::open_memstream(&text, &size);
  {
    replay::ReplayLines lines(rig, memory);
    lines.on_measurement(m);
    lines.flush();
  }
  std::fclose(memory);
  std::string line(text, size);
  std::free(text);
  return line;
}

Heard run(const rig_config::Rig& rig, const std::string& device) {
  Heard result;
  const auto index = static_cast<std::size_t>(
      std::ranges::find(rig.devices, device, &rig_config::DeviceConfig::name) -
      rig.devices.begin());
  const auto start = measurement::stamp_from_ns(rig.start_utc_ns);
  bench::RunOptions options;
  options.duration_s = end_s;
  bench::EachMeasurement each([&](const measurement::Measurement& m) {
    const auto& origin = measurement::origin_of(m);
    if (origin.device != index) return;
    result.lines.push_back(text_of(rig, m));
    result.received_s.push_back(measurement::seconds(origin.received_at - start));
  });
  options.followers = {&each};
  testing::internal::CaptureStdout();
  result.device = bench::run_lockstep(rig, options).devices.at(index);
  testing::internal::GetCapturedStdout();
  return result;
}

Heard run_under(const Case& c) {
  auto rig = rig_at_the_surface();
  rig.faults =
      rig_config::load_faults_text("[[fault]]\ndevice = \"" + c.device + "\"\nfault = \"" +
                                       c.fault + "\"\nstart_s = 20\nfor_s = 6\n" + c.more + "\n",
                                   "test")
          .value();
  EXPECT_THAT(rig_config::check_faults_of(rig), testing::IsEmpty());
  return run(rig, c.device);
}

/// The words that power_up_test.cpp tries on devices that the demo does not have.
bool is_tried_elsewhere(std::string_view word) { return word == "nak" || word == "hot"; }

/// The cases above, and one for each further word of the vocabulary.
std::vector<Case> every_case() {
  std::vector<Case> all(std::begin(cases), std::end(cases));
  const auto rig = rig_at_the_surface();
  for (const auto& word : rig_config::fault_vocabulary()) {
    if (is_tried_elsewhere(word.name) || std::ranges::count(all, word.name, &Case::fault)) continue;
    rig_config::FaultConfig fault;
    fault.kind = word.kind;
    const auto device = std::ranges::find_if(
        rig.devices, [&](const auto& each) { return !rig_config::refusal(fault, each); });
    if (device == rig.devices.end())
      throw std::logic_error("no device of the demo can have " + std::string(word.name));
    all.push_back({device->name, std::string(word.name), std::string(word.facts.scorecard)});
  }
  return all;
}

class EachFault : public testing::TestWithParam<Case> {};

TEST_P(EachFault, SetsWhenItStartsAndIsGoneOnceItHasCleared) {
  const Case& c = GetParam();
  const Heard sound = run(rig_at_the_surface(), c.device), faulty = run_under(c);
  ASSERT_GT(sound.between(0, sets_s).size(), 20u);
  EXPECT_EQ(faulty.between(0, sets_s), sound.between(0, sets_s)) << "before it sets";

  const bool seen = faulty.between(sets_s, clears_s) != sound.between(sets_s, clears_s) ||
                    (sound.device.last_error.empty() && !faulty.device.last_error.empty());
  EXPECT_TRUE(seen) << "while it holds";

  const auto after = faulty.between(settled_s, end_s), as_ever = sound.between(settled_s, end_s);
  if (c.for_good) {
    EXPECT_NEAR(static_cast<double>(after.size()), static_cast<double>(as_ever.size()), 2);
  } else {
    EXPECT_EQ(after, as_ever) << "once it has gone";
  }
  EXPECT_EQ(faulty.device.state, "streaming") << faulty.device.last_error;
}

INSTANTIATE_TEST_SUITE_P(Vocabulary, EachFault, testing::ValuesIn(every_case()),
                         [](const auto& each) {
                           std::string name = each.param.fault;
                           std::erase(name, '-');
                           return name;
                         });

TEST(FaultVocabulary, ACanopenNodeThatWasWithoutPowerIsStartedAgain) {
  const Heard heard = run_under({"imu", "off"});
  EXPECT_THAT(heard.between(20.1, 26), testing::IsEmpty());
  EXPECT_NEAR(static_cast<double>(heard.between(27, 60).size()), 3300, 2);
  EXPECT_EQ(heard.device.state, "streaming");
}

}  // namespace
}  // namespace fault_run_test
