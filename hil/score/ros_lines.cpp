#include "hil/score/ros_lines.hpp"

#include <algorithm>

#include "hil/score/numbers.hpp"

namespace drydock::score {
namespace {

using Names = std::vector<std::string>;

Names joined(std::initializer_list<Names> parts) {
  Names all;
  for (const Names& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Cells that are not read.
Names cells_of(const std::string& name, int size) {
  Names names;
  for (int i = 0; i < size; ++i) names.push_back(name + "[" + std::to_string(i) + "]");
  return names;
}

const Names header_names{"header.stamp.sec", "header.stamp.nanosec", "header.frame_id"};
const Names orientation{"orientation.x", "orientation.y", "orientation.z", "orientation.w"};
const Names position{"position.x", "position.y", "position.z"};
const Names twist{"twist.linear.x",  "twist.linear.y",  "twist.linear.z",
                  "twist.angular.x", "twist.angular.y", "twist.angular.z"};

}  // namespace

std::vector<std::string> names_of_ros_line(const std::vector<std::string>& cells) {
  if (cells.size() < 3 || !number_of(cells[0]) || !number_of(cells[1]) || number_of(cells[2]))
    return {};
  const Names pose = joined({position, orientation});
  const Names matrix = cells_of("covariance", 36);
  const std::vector<Names> messages{
      joined({header_names,
              {"child_frame_id"},
              pose,
              matrix,
              twist,
              cells_of("twist.covariance", 36)}),
      joined({header_names, pose, matrix}),
      joined({header_names, pose}),
      joined({header_names, twist, matrix}),
      joined({header_names, twist}),
      joined({header_names,
              {"status.status", "status.service", "latitude", "longitude", "altitude"},
              cells_of("position_covariance", 9),
              {"position_covariance_type"}}),
      joined({header_names, orientation, cells_of("covariances", 33)})};
  const auto found = std::ranges::find(messages, cells.size(), &Names::size);
  return found == messages.end() ? Names{} : *found;
}

}  // namespace drydock::score
