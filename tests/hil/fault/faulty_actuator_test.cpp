#include "hil/fault/faulty_device.hpp"
#include "hil/fault/schedule/schedules.hpp"
#include "rig_config/fault_vocabulary.hpp"
#include "tests/hil/emulate/ordered_node.hpp"

namespace drydock::fault {
namespace {

using namespace emulate;

/// The rudder's node under a fault of the rig from 1 s to 5 s.
struct Faulty {
  Faulty(rig_config::FaultKind kind, double amount) {
    rig_config::FaultConfig fault;
    fault.device = config.name;
    fault.kind = kind;
    fault.start_s = 1;
    fault.for_s = 4;
    fault.amount[0] = amount;
    rig.devices = {config};
    rig.faults = {fault};
    schedules.emplace(rig, start, rig_config::FaultTarget::emulated);
    device = *FaultyDevice::make(config, vehicle, 1, schedules->of(config.name));
    sent.run(*device, at_s(0.5));
  }
  void order(const std::string& angle, double until_s) {
    device->receive(wire::test::frame("09F10D20#00F8" + angle + "FF7FFFFF"), sent.now, sent);
    sent.run(*device, at_s(until_s));
  }
  double rudder(double t) const { return vehicle.at(at_s(t)).rudder_rad / degree; }

  rig_config::DeviceConfig config = actuator("nmea2000", 0);
  rig_config::Rig rig;
  motion::OrderedTrajectory vehicle{under_orders(), start};
  std::optional<Schedules> schedules;
  std::unique_ptr<FaultyDevice> device;
  Recorder sent;
};

TEST(FaultyActuator, AStuckRudderStandsAndThenFollowsAgain) {
  Faulty rudder(FaultKind::stuck, 0);
  rudder.order("D106", 1.2);  // 10 degrees to starboard from 0.5 s on: 1.25 degrees when it sticks
  for (int i = 0; i < 4; ++i) rudder.order("D106", 2 + i);
  EXPECT_NEAR(rudder.rudder(4.5), -1.25, 0.03);
  rudder.order("D106", 6);
  EXPECT_NEAR(rudder.rudder(6), -1.25 - 2.5, 0.08);  // two cycles of 10 ms later
}

TEST(FaultyActuator, ALateRudderMovesLaterByTheDelay) {
  Faulty rudder(FaultKind::delay, 0.8);
  rudder.sent.run(*rudder.device, at_s(2));
  rudder.order("D106", 2.1);
  EXPECT_NEAR(rudder.rudder(2.8), 0, 1e-9);
  EXPECT_NEAR(rudder.rudder(3.8), -2.5, 0.03);
}

TEST(FaultyActuator, ANodeThatHangsHearsNoOrder) {
  Faulty rudder(FaultKind::hang, 0);
  rudder.sent.run(*rudder.device, at_s(2));
  rudder.order("D106", 3);
  EXPECT_EQ(rudder.rudder(3), 0);
}

}  // namespace
}  // namespace drydock::fault
