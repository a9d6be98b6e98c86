#pragma once

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/measurement/stamp.hpp"
#include "hil/motion/truth.hpp"
#include "hil/steer/joint.hpp"

namespace drydock::steer {

using measurement::Stamp;

/// The faults of the device that has the name of a joint.
struct JointTrouble {
  bool stuck = false;                ///< thruster and propeller stop, a surface stands where it is
  bool powerless = false;            ///< thruster and propeller stop, a surface keeps its order
  bool deaf = false;                 ///< it hears no order
  std::chrono::nanoseconds late{0};  ///< it takes up an order so much later
};

/// By joint.
using JointTroubles = std::map<std::string, JointTrouble, std::less<>>;
using JointTroublesAt = std::function<JointTroubles(Stamp now)>;

/// What the actuators of joints make of their orders. An actuator without an order for a second
/// goes to its safe state: a surface amidships, a thruster and a propeller to rest. Orders and
/// outputs are shares of the full command, -1 to 1. Sans-I/O.
class JointActuators {
 public:
  static constexpr std::chrono::seconds patience{1};

  explicit JointActuators(std::vector<Joint> joints)
      : joints_(std::move(joints)), channels_(joints_.size()), outputs_(joints_.size(), 0) {}

  void order(std::size_t joint, double share, Stamp now);
  void set_troubles(JointTroubles troubles) { troubles_ = std::move(troubles); }

  /// For a SteeredVehicle, in the order of joints(). `vehicle` is how it is now. Calls
  /// `timed_out(joint)` for each that goes to its safe state.
  using TimedOut = std::function<void(const Joint& joint)>;
  std::span<const double> outputs(Stamp now, const motion::Truth& vehicle,
                                  const TimedOut& timed_out);

  const std::vector<Joint>& joints() const { return joints_; }

 private:
  struct Order {
    Stamp at{};
    double share = 0;
  };
  struct Channel {
    std::deque<Order> coming;
    std::optional<Order> held;           ///< empty: the joint is in its safe state
    std::optional<double> stuck_at_rad;  ///< empty: the joint is not stuck
  };

  /// False: it has waited too long.
  static bool follow(Channel& channel, Stamp now);
  double share_while_stuck(std::size_t joint, const motion::Truth& vehicle);
  JointTrouble trouble_of(const std::string& name) const;

  std::vector<Joint> joints_;
  std::vector<Channel> channels_;
  std::vector<double> outputs_;
  JointTroubles troubles_;
};

/// "no order for rudder for 1 s: it goes to its safe state"
std::string words_of_time_out(const Joint& joint);

}  // namespace drydock::steer
