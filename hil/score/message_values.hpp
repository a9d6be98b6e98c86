#pragma once

#include <Eigen/Core>
#include <limits>
#include <map>
#include <string>

namespace drydock::score {

/// The numbers of a ROS 2 message by their names, such as "pose.pose.position.x"; one that is not
/// finite is NaN.
struct MessageValues {
  std::map<std::string, double> numbers;
  std::string frame;  ///< header.frame_id

  bool has(const std::string& name) const { return numbers.contains(name); }
  double at(const std::string& name) const {
    const auto found = numbers.find(name);
    return found == numbers.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
  }
  Eigen::Vector3d vector(const std::string& name) const {
    return {at(name + ".x"), at(name + ".y"), at(name + ".z")};
  }
  /// Three rows and columns of an array with `width` columns, from `first` on along its diagonal.
  Eigen::Matrix3d block(const std::string& name, int width, int first) const {
    Eigen::Matrix3d values;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        values(row, column) =
            at(name + "[" + std::to_string((first + row) * width + first + column) + "]");
    return values;
  }
};

}  // namespace drydock::score
