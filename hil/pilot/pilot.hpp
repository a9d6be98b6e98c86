#pragma once

#include "hil/motion/vehicle/autopilot.hpp"
#include "hil/motion/vehicle/mission_plan.hpp"
#include "hil/pilot/measured_state.hpp"
#include "hil/pilot/order_ports.hpp"
#include "hil/pilot/reckoned_place.hpp"

namespace drydock::pilot {

/// Sails the legs or the waypoints of a mission from the other end of the wires: measurements come
/// in, frames for the actuators go out. Its laws are those of motion::Autopilot, but it knows only
/// what sensors say, and acts 20 times a second. Without a fresh measurement it gives no orders,
/// and the actuators go to their safe state. Sans-I/O.
class Pilot {
 public:
  static constexpr std::chrono::milliseconds period{50};

  /// The mission needs a vehicle and a plan, whose time counts from `start`. Throws
  /// std::runtime_error (one line) if the rig lacks a sensor or an actuator, and BadMission.
  Pilot(const rig_config::Rig& rig, Stamp start, const OrderPorts::Send& send, OrderPorts::Say say);

  void receive(const measurement::Measurement& m) {
    state_.receive(m);
    place_.receive(m);
  }
  OrderPorts& ports() { return ports_; }
  const OrderPorts& ports() const { return ports_; }

  std::optional<Stamp> deadline() const;
  void tick(Stamp now);  ///< called at or after deadline()

  std::uint64_t orders() const { return orders_; }      ///< how many it gave
  std::uint64_t silences() const { return silences_; }  ///< how often it had none to give

 private:
  void steer(Stamp now);
  void tell(const motion::Passed& passed, Stamp now) const;

  MeasuredState state_;
  ReckonedPlace place_;
  motion::MissionPlan plan_;
  motion::Autopilot autopilot_;
  motion::AutopilotMemory memory_;
  double advance_m_;
  OrderPorts ports_;
  OrderPorts::Say say_;
  Stamp start_, next_;
  std::uint64_t orders_ = 0, silences_ = 0;
  bool was_blind_ = false;
};

/// True if the rig's vehicle takes orders and has a plan that somebody must sail.
bool is_wanted(const rig_config::Rig& rig);

}  // namespace drydock::pilot
