#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "drivers/bus/participant.hpp"
#include "drivers/measurement/joint_order.hpp"

namespace drydock::bus {

/// Where other programs give orders to the joints of a vehicle, and to its body.
inline constexpr const char* joint_orders_topic = "rt/command/joints";
inline constexpr const char* wrench_orders_topic = "rt/command/wrench";

/// Reads the orders of other programs: sensor_msgs/JointState, whose `name` says which joints the
/// lists are for, and geometry_msgs/Wrench in forward-left-up axes (REP-103).
class OrderReader {
 public:
  using OnJoints = std::function<void(const std::vector<measurement::JointOrder>&)>;
  using OnWrench = std::function<void(const measurement::BodyWrench&)>;

  explicit OrderReader(const Participant& participant);  ///< throws bus::Error
  ~OrderReader();
  OrderReader(const OrderReader&) = delete;
  OrderReader& operator=(const OrderReader&) = delete;

  /// Gives what has come since the last call, in order of each topic. Never waits.
  void take(const OnJoints& on_joints, const OnWrench& on_wrench);
  std::size_t matched_writers() const;
  /// Messages that cannot be an order: a value that is not finite, or a list whose length is
  /// neither 0 nor that of `name`.
  std::uint64_t unusable() const;

 private:
  struct Readers;
  std::unique_ptr<Readers> readers_;
};

}  // namespace drydock::bus
