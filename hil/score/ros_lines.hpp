#pragma once

#include <string>
#include <vector>

namespace drydock::score {

/// The names of the columns of `ros2 topic echo --csv`, which writes none: by how many cells a line
/// of a message has. Empty: no message that gives estimates has so many.
std::vector<std::string> names_of_ros_line(const std::vector<std::string>& cells);

}  // namespace drydock::score
