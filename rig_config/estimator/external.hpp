#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rig_config/estimator/facts.hpp"

namespace drydock::rig_config {

struct Node;

/// What each of its estimates has.
enum class ExternalGives : std::uint8_t { attitude, navigation, velocity };
/// The ROS 2 messages that it may publish: sensor_msgs/Imu, nav_msgs/Odometry,
/// geometry_msgs/PoseWithCovarianceStamped and TwistWithCovarianceStamped, sensor_msgs/NavSatFix.
enum class OutsideMessage : std::uint8_t { imu, odometry, pose, twist, fix };
inline constexpr std::array outside_message_names{"imu", "odometry", "pose", "twist", "fix"};
inline constexpr std::array external_gives_names{"attitude", "navigation", "velocity"};

/// An estimator in another program. docs/build/external-estimator.md
struct ExternalConfig {
  static constexpr EstimatorFacts facts{.name = "external", .devices = {}, .gives_positions = true};
  static constexpr EstimatorFacts attitude_facts{.name = facts.name, .devices = {}};

  /// One that gives attitudes alone has no topic of positions.
  const EstimatorFacts& own_facts() const {
    return gives == ExternalGives::attitude ? attitude_facts : facts;
  }

  std::vector<std::string> command;  ///< the program and its arguments; empty: a topic
  std::string topic;                 ///< ROS 2's name: /my/odometry
  OutsideMessage message = OutsideMessage::odometry;  ///< on the topic
  /// Where the axes of its poses begin; empty: where the mission does. Radians and metres.
  std::optional<std::array<double, 3>> origin;
  ExternalGives gives = ExternalGives::attitude;
  double step_s = 0.05;
  double answer_within_s = 2;
};

void read_kind(const Node& table, ExternalConfig& into);

/// None: the other program does not tell what it compares.
std::vector<std::string> compared_devices(const ExternalConfig& config);

}  // namespace drydock::rig_config
