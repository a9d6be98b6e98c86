#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace drydock::score {

/// The covariances of ROS's messages in columns: 36 numbers by rows, of x, y, z and of turns about
/// them.
inline constexpr const char *csv_pose_covariance = "pose_covariance",
                            *csv_twist_covariance = "twist_covariance";

/// The name of such a column in this program: `pose_covariance_7`.
std::string covariance_column(std::string_view of, std::size_t row, std::size_t column);

/// The same for what others write: `pose.covariance.7`, `field.pose.covariance7`,
/// `/odom/pose/covariance[7]`. Empty: it is none.
std::optional<std::string> covariance_named(std::string_view written);

/// Of a name that covariance_column() gives.
bool is_covariance_column(std::string_view name);

}  // namespace drydock::score
