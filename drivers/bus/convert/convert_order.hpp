#pragma once

#include <vector>

#include "drivers/bus/message_types.hpp"
#include "drivers/measurement/joint_order.hpp"

/// Reads orders of other programs. False: the content cannot be an order.
namespace drydock::bus {

bool read(std::vector<measurement::JointOrder>& orders, const JointStateMessage& message);
bool read(measurement::BodyWrench& wrench, const WrenchMessage& message);

}  // namespace drydock::bus
