#pragma once

#include <gtest/gtest.h>

#include "hil/motion/ordered/ordered_trajectory.hpp"
#include "rig_config/load.hpp"
#include "tests/drivers/wire/can_fixture.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {

using wire::test::frame;
using wire::test::text_of;

/// The NPS AUV II under way, 20 m deep.
inline rig_config::MissionConfig under_orders() {
  rig_config::MissionConfig mission;
  mission.latitude_rad = 36 * degree;
  mission.depth_m = 20;
  mission.speed_mps = 1.8;
  mission.vehicle =
      rig_config::load_vehicle(DRYDOCK_SOURCE_DIR "/rig_config/vehicles/nps-auv-ii.toml").value();
  return mission;
}

inline rig_config::DeviceConfig actuator(std::string protocol, int instance) {
  auto config = device(rig_config::DeviceKind::actuator, std::move(protocol), 10);
  config.instance = instance;
  return config;
}

/// An emulated node that has booted, and the vehicle that it moves.
struct Node {
  explicit Node(const rig_config::DeviceConfig& config,
                std::unique_ptr<motion::Trajectory> moved =
                    std::make_unique<motion::OrderedTrajectory>(under_orders(), start))
      : vehicle(std::move(moved)), device(make_emulated_device(config, *vehicle, 1).value()) {
    run(0.5);
  }
  void run(double until_s) { sent.run(*device, at_s(until_s)); }
  void hear(const std::string& text) { device->receive(frame(text), sent.now, sent); }
  /// Lets the time go on to t.
  motion::Truth at(double t) {
    run(t);
    return vehicle->at(at_s(t));
  }

  std::unique_ptr<motion::Trajectory> vehicle;
  std::unique_ptr<EmulatedDevice> device;
  Recorder sent;
};

}  // namespace drydock::emulate
