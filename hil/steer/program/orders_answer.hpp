#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "drivers/measurement/joint_order.hpp"
#include "estimators/external/program_dialogue.hpp"
#include "hil/steer/joint.hpp"

namespace drydock::steer {

/// What a program that steers answers to a step: docs/world/steering-program.md
struct OrdersAnswer {
  external::Heard heard;
  std::vector<measurement::JointOrder> orders;  ///< the good ones, before the flaw
  std::optional<measurement::BodyWrench> wrench{};
};

/// An order for a joint that the vehicle does not have, or without the value that it obeys, is a
/// flaw.
OrdersAnswer read_orders(std::string_view line, const std::vector<Joint>& joints);

}  // namespace drydock::steer
