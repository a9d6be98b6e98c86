#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "drivers/bus/outside_reader.hpp"
#include "estimators/external/gives.hpp"
#include "estimators/frame/geodetic.hpp"

namespace drydock::external {

/// An estimator on a topic of the bus.
struct TopicOptions {
  std::string estimator, topic;
  bus::OutsideType type = bus::OutsideType::odometry;
  Gives gives = Gives::navigation;
  frame::Position origin;  ///< where the axes of the program's poses begin
  std::uint32_t domain = 0;
  std::string interface;
  std::function<void(const std::string&)> say;
};

}  // namespace drydock::external
