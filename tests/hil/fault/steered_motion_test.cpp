#include <array>
#include <set>
#include <string>

#include "hil/fault/faulty_device.hpp"
#include "hil/motion/steered/steered_trajectory.hpp"
#include "rig_config/fault_vocabulary.hpp"
#include "rig_config/load.hpp"
#include "tests/hil/emulate/ordered_node.hpp"

namespace drydock::fault {
namespace {

using namespace emulate;

rig_config::MissionConfig rov() {
  return rig_config::load_mission(DRYDOCK_SOURCE_DIR "/rig_config/missions/rov.toml").value();
}

// The motion of a steered vehicle keeps its last 1024 steps: 5 s of steps of 5 ms.
TEST(StuckSensor, SaysTheSameForLongerThanASteeredMotionIsKept) {
  motion::SteeredTrajectory vehicle(rov(), start);
  rig_config::FaultConfig stuck;
  stuck.device = "nmea0183 device";
  stuck.kind = rig_config::FaultKind::stuck;
  stuck.start_s = 2;
  Schedule schedule(start);
  schedule.add(stuck);
  const auto config = emulate::device(rig_config::DeviceKind::emlog, "nmea0183", 5);
  const auto sensor =
      *FaultyDevice::make(config, vehicle, 1, std::make_shared<const Schedule>(schedule));
  Recorder sent;
  const auto lines = [&](double from_s, double to_s) {
    sent.messages.clear();
    const std::array<double, 4> ahead{-1, -1, 1, 1};
    for (double t = from_s; t < to_s; t += 0.005) {
      vehicle.step(ahead, 0.005, at_s(t));
      sent.run(*sensor, at_s(t));
    }
    std::set<std::string> speeds;
    for (const auto& message : sent.messages) {
      const std::string text(message.bytes.begin(), message.bytes.end());
      if (text.find("VHW") != text.npos) speeds.insert(text);
    }
    return speeds;
  };
  EXPECT_GT(lines(0.1, 1.9).size(), 3u) << "it speeds up";
  lines(1.9, 2.4);
  EXPECT_EQ(lines(2.4, 20).size(), 1u);
}

}  // namespace
}  // namespace drydock::fault
