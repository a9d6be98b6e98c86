#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "estimators/frame/geodetic.hpp"
#include "hil/score/message_values.hpp"
#include "hil/score/track.hpp"

namespace drydock::score {

/// What a message of an estimator says.
struct MessageState {
  State state;
  std::vector<std::string> remarks;  ///< what of it is not taken, and how it is taken
  bool default_attitude = false;     ///< that of a message that nobody filled in
  bool default_velocity = false;
};

/// A type of ROS 2 messages that give estimates.
struct MessageType {
  std::string_view name;                ///< "nav_msgs/msg/Odometry"
  std::span<const char* const> fields;  ///< that it must have
  /// Places in degrees are counted from `origin`.
  MessageState (*read)(const MessageValues& values, const frame::Position& origin);

  std::string short_name() const;  ///< "nav_msgs/Odometry"
};

/// Those that tell most come first.
std::span<const MessageType> message_types();

}  // namespace drydock::score
