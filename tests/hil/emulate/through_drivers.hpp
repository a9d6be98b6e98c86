#pragma once

#include <gtest/gtest.h>

#include <string_view>
#include <variant>
#include <vector>

#include "drivers/device/make_driver.hpp"
#include "hil/emulate/lockstep.hpp"
#include "hil/motion/kinematic_trajectory.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {

/// All devices of a vehicle that turns and dives, through real drivers. The measurements must equal
/// the truth at their valid_at.
class ThroughDrivers : public testing::Test, protected device::Output {
 protected:
  ThroughDrivers() : trajectory_(mission(), start) {}

  static rig_config::MissionConfig mission() {
    using enum rig_config::LegKind;
    rig_config::MissionConfig mission;
    mission.latitude_rad = 47 * degree;
    mission.depth_m = 0;
    mission.speed_mps = 2;
    mission.ocean.bed.depth_m = 60;
    mission.legs = {
        {.kind = turn, .duration_s = 30, .turn_rad = 1.2, .speed_mps = 2.5, .roll_rad = -0.1},
        {.kind = dive, .duration_s = 60, .depth_change_m = 20, .speed_mps = 2}};
    return mission;
  }

  static device::DriverOptions options(device::Kind kind, const rig_config::DeviceConfig& config) {
    device::DriverOptions options;
    options.kind = kind;
    options.protocol = config.protocol;
    options.address = static_cast<std::uint8_t>(config.address);
    options.water.density_kgm3 = config.water_density_kgm3;
    options.mounting = {config.mounting_rad[0], config.mounting_rad[1], config.mounting_rad[2]};
    if (config.maker == rig_config::DvlMaker::water_linked) {
      options.dvl.maker = device::DvlMaker::water_linked;
    }
    options.dvl.velocity_of_bed = config.velocity_of_bed;
    options.speed_scale = config.speed_scale;
    options.compass_error_rad = config.compass_error_rad;
    return options;
  }

  // Runs through both legs and collects the measurements.
  void run_line(device::Kind kind, const rig_config::DeviceConfig& config, unsigned baud) {
    auto with_baud = options(kind, config);
    with_baud.baud = baud;
    const auto made = device::make_byte_driver(with_baud);
    ASSERT_TRUE(made);
    const auto& driver = *made;
    driver->restart(start, *this);
    EmulatedLine line(make_emulated_device(config, trajectory_, 1).value(), baud,
                      [&](wire::Bytes bytes, const Passage& passage) {
                        driver->receive(bytes, passage.ended_at, *this);
                      });
    run(line);
  }

  void run_bus(device::Kind kind, const rig_config::DeviceConfig& config) {
    const auto made = device::make_frame_driver(options(kind, config));
    ASSERT_TRUE(made);
    const auto& driver = *made;
    EmulatedBus bus(250'000, [&](const wire::CanFrame& frame, std::size_t, const Passage& passage) {
      now_ = passage.ended_at;
      driver->receive(frame, now_, *this);
    });
    bus_ = &bus;
    now_ = start;
    driver->restart(start, *this);
    bus.add(make_emulated_device(config, trajectory_, 1).value());
    run(bus);
  }

  void run(shell::Actor& actor) {
    shell::Lockstep lockstep(start);
    lockstep.add(actor);
    lockstep.run_until(at_s(90));
  }

  template <class Sample>
  std::vector<Sample> all() const {
    std::vector<Sample> found;
    for (const auto& m : measurements_) {
      if (const auto* sample = std::get_if<Sample>(&m)) found.push_back(*sample);
    }
    return found;
  }

  void publish(const measurement::Measurement& m) override { measurements_.push_back(m); }
  void send(wire::Bytes bytes) override {
    if (line_) line_->receive(bytes, now_);
  }
  void send(const wire::CanFrame& frame) override { bus_->receive(frame, now_); }
  void report(std::string_view what) override { ADD_FAILURE() << what; }
  void refuse(std::string_view why, device::Refusal because) override {
    if (because != device::Refusal::no_measurement) report(why);
  }

  motion::KinematicTrajectory trajectory_;
  std::vector<measurement::Measurement> measurements_;
  EmulatedLine* line_ = nullptr;
  EmulatedBus* bus_ = nullptr;
  Stamp now_ = start;
};

}  // namespace drydock::emulate
