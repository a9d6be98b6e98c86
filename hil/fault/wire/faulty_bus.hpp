#pragma once

#include "hil/fault/rogue_node.hpp"
#include "hil/fault/schedule/schedule_follower.hpp"
#include "hil/fault/wire/device_frames.hpp"
#include "hil/fault/wire/faulty_wire.hpp"
#include "hil/fault/wire/outlet.hpp"

namespace drydock::fault {

using rig_config::DeviceConfig;

/// A real or recorded CAN bus on its way to the drivers, with faults on one of its devices. Only
/// the frames of that device suffer. Bus-off and error frames reach all drivers.
class FaultyBus final : private emulate::Wire {
 public:
  FaultyBus(const DeviceConfig& device, unsigned bit_rate, std::uint64_t seed,
            const std::shared_ptr<Schedule>& schedule, Stamp start);

  void receive(const wire::CanFrame& frame, Stamp now, Outlet& drivers);
  std::optional<Stamp> deadline() const;
  void tick(Stamp now, Outlet& drivers);

  /// True if frames from the drivers reach the bus.
  bool hears() const { return !cut_off_ && !(wire_.silent() && device_.are_all()); }
  bool has_port() const { return true; }  ///< a bus cannot be unplugged
  void drop_all() { wire_.drop_all(); }
  FaultHits hits() const;

 private:
  void follow(Stamp now, Outlet& drivers);
  void release(Stamp now, Outlet& drivers);

  void send(wire::Bytes) override {}
  void send(const wire::CanFrame& error_frame) override;
  void unplug() override;
  void plug() override { cut_off_ = false; }

  DeviceFrames device_;
  ScheduleFollower schedule_;
  FaultyWire<wire::CanFrame> wire_;
  RogueNode controller_;  ///< the drivers' controller: sees errors, goes bus-off
  bool cut_off_ = false;
  FaultHits hits_;
  Outlet* drivers_ = nullptr;  ///< valid during a call
  Stamp now_{};
};

}  // namespace drydock::fault
