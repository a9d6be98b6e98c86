#pragma once

#include <functional>
#include <string>

#include "hil/score/csv_head.hpp"
#include "hil/score/track.hpp"

namespace drydock::score {

/// What the columns of covariances of a ROS message tell of a line: of places east, north, up, of
/// turns about them, and of velocities forward, left, up. `number`: of a column that is there or
/// not (NaN). `note`: hears why one tells nothing.
void tell_ros_covariances(const CsvHead& head,
                          const std::function<double(const std::string&)>& number,
                          const std::function<void(const std::string&)>& note, State& state);

}  // namespace drydock::score
