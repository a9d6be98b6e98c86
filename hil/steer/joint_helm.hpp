#pragma once

#include <deque>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "drivers/measurement/stamp.hpp"
#include "hil/motion/truth.hpp"
#include "hil/steer/joint.hpp"
#include "hil/steer/thrust_allocation.hpp"

namespace drydock::steer {

using measurement::Stamp;

/// The faults of the device that has the name of a joint.
struct JointTrouble {
  bool stuck = false;                ///< thruster and propeller stop, a surface stands where it is
  bool powerless = false;            ///< thruster and propeller stop, a surface keeps its order
  bool deaf = false;                 ///< it hears no order
  std::chrono::nanoseconds late{0};  ///< it takes up an order so much later
};

struct HelmCounters {
  std::uint64_t orders = 0, wrenches = 0;
  std::uint64_t limited = 0;   ///< orders beyond the limit of a joint
  std::uint64_t refused = 0;   ///< orders to unknown joints, or without the value that they obey
  std::uint64_t timeouts = 0;  ///< how often a joint went to its safe state
};

/// Orders to the joints of a vehicle, or to its whole body, as outputs for a SteeredVehicle. A
/// joint without an order for a second goes to its safe state: a surface amidships, a thruster and
/// a propeller to rest. Sans-I/O.
class JointHelm {
 public:
  using Say = std::function<void(const std::string& line)>;
  using Troubles = std::map<std::string, JointTrouble, std::less<>>;
  static constexpr std::chrono::seconds patience{1};

  /// `mission` needs a vehicle. Lines for the person at the bench go to `say`.
  JointHelm(const rig_config::MissionConfig& mission, Say say);

  void order(std::span<const measurement::JointOrder> orders, Stamp now);
  /// For a vehicle with thrusters; it replaces the orders of all of them.
  void order(const measurement::BodyWrench& wrench, Stamp now);
  void set_troubles(Troubles troubles) { troubles_ = std::move(troubles); }

  /// Shares of the full command, -1 to 1, in the order of joints(). `vehicle` is how it is now.
  std::span<const double> outputs(Stamp now, const motion::Truth& vehicle);

  const std::vector<Joint>& joints() const { return joints_; }
  const HelmCounters& counters() const { return counters_; }

 private:
  struct Order {
    Stamp at{};
    double value = 0;
  };
  struct Channel {
    std::deque<Order> coming;
    std::optional<Order> held;           ///< empty: the joint is in its safe state
    std::optional<double> stuck_at_rad;  ///< empty: the joint is not stuck
  };

  void give(std::size_t joint, double value, Stamp now);
  void refuse(const std::string& name, const std::string& why);
  void follow(Channel& channel, const std::string& name, Stamp now);
  double share_of(std::size_t joint) const;
  double share_while_stuck(std::size_t joint, const motion::Truth& vehicle);
  JointTrouble trouble_of(const std::string& name) const;

  std::vector<Joint> joints_;
  std::vector<motion::Thruster> thrusters_;
  std::optional<ThrustAllocation> allocation_;  ///< empty: a vehicle with fins
  Say say_;
  Troubles troubles_;
  std::vector<Channel> channels_;
  std::vector<double> outputs_;
  HelmCounters counters_;
  std::set<std::string, std::less<>> told_;
};

/// How the orders went, as lines for the end of a run.
std::vector<std::string> notes_of(const HelmCounters& counters, std::uint64_t unusable);

}  // namespace drydock::steer
