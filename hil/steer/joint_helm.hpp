#pragma once

#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "hil/steer/joint_actuators.hpp"
#include "hil/steer/thrust_allocation.hpp"

namespace drydock::steer {

struct HelmCounters {
  std::uint64_t orders = 0, wrenches = 0;
  std::uint64_t limited = 0;   ///< orders beyond the limit of a joint
  std::uint64_t refused = 0;   ///< orders to unknown joints, or without the value that they obey
  std::uint64_t timeouts = 0;  ///< how often a joint went to its safe state
};

/// Orders to the joints of a vehicle, in the units of those who steer, or to its whole body, as
/// outputs for a SteeredVehicle. Sans-I/O.
class JointHelm {
 public:
  using Say = std::function<void(const std::string& line)>;

  /// `mission` needs a vehicle. Lines for the person at the bench go to `say`.
  JointHelm(const rig_config::MissionConfig& mission, Say say);

  void order(std::span<const measurement::JointOrder> orders, Stamp now);
  /// For a vehicle with thrusters; it replaces the orders of all of them.
  void order(const measurement::BodyWrench& wrench, Stamp now);
  void set_troubles(JointTroubles troubles) { actuators_.set_troubles(std::move(troubles)); }

  /// Shares of the full command, -1 to 1, in the order of joints(). `vehicle` is how it is now.
  std::span<const double> outputs(Stamp now, const motion::Truth& vehicle);

  const std::vector<Joint>& joints() const { return actuators_.joints(); }
  const HelmCounters& counters() const { return counters_; }

 private:
  void give(std::size_t joint, double value, Stamp now);
  void refuse(const std::string& name, const std::string& why);
  double share_of(std::size_t joint, double value) const;

  JointActuators actuators_;
  std::vector<motion::Thruster> thrusters_;
  std::optional<ThrustAllocation> allocation_;  ///< empty: a vehicle with fins
  Say say_;
  HelmCounters counters_;
  std::set<std::string, std::less<>> told_;
};

/// How the orders went, as lines for the end of a run. `from`: who gave them; `unusable`: messages
/// that were no order.
std::vector<std::string> notes_of(std::string_view from, const HelmCounters& counters,
                                  std::uint64_t unusable);

}  // namespace drydock::steer
