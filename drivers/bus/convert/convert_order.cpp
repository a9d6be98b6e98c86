#include "drivers/bus/convert/convert_order.hpp"

#include <cmath>
#include <span>

#include "drivers/bus/convert/convert.hpp"

namespace drydock::bus {
namespace {

std::span<const double> list_of(const dds_sequence_double& sequence) {
  return {sequence._buffer, sequence._length};
}

/// False: the list has another length than the names, or a value that is not finite.
bool set_all(std::vector<measurement::JointOrder>& orders, std::span<const double> list,
             std::optional<double> measurement::JointOrder::*member) {
  if (list.empty()) return true;
  if (list.size() != orders.size()) return false;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!std::isfinite(list[i])) return false;
    orders[i].*member = list[i];
  }
  return true;
}

Eigen::Vector3d from_forward_left_up(const Vector3Message& v) { return {v.x, -v.y, -v.z}; }

}  // namespace

bool read(std::vector<measurement::JointOrder>& orders, const JointStateMessage& message) {
  using measurement::JointOrder;
  for (std::uint32_t i = 0; i < message.name._length; ++i)
    orders.push_back({message.name._buffer[i]});
  return !orders.empty() && set_all(orders, list_of(message.position), &JointOrder::position_rad) &&
         set_all(orders, list_of(message.velocity), &JointOrder::velocity_radps) &&
         set_all(orders, list_of(message.effort), &JointOrder::effort_n);
}

bool read(measurement::BodyWrench& wrench, const WrenchMessage& message) {
  wrench.force_n = from_forward_left_up(message.force);
  wrench.moment_nm = from_forward_left_up(message.torque);
  return wrench.force_n.allFinite() && wrench.moment_nm.allFinite();
}

}  // namespace drydock::bus
