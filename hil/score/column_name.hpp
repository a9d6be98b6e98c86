#pragma once

#include <string>
#include <string_view>

namespace drydock::score {

/// A column by its name in this program's files.
struct Column {
  std::string name;
  double factor = 1;  ///< of its numbers
};

/// Names of times that stand in no file of this program's own.
inline constexpr const char* csv_second = "stamp_sec";  ///< whole seconds, beside the next
inline constexpr const char* csv_nanosecond = "stamp_nanosec";
inline constexpr const char* csv_milliseconds = "t_ms";
inline constexpr const char* csv_microseconds = "t_us";
inline constexpr const char* csv_stamp = "stamp";  ///< of a message; its number tells the unit
inline constexpr const char* csv_time = "t";       ///< likewise, of a logger

/// What other programs name so: `p_RS_R_x [m]`, `field.pose.pose.position.x`, `lat(deg)`. Of axes
/// x, y, z it is REP-103's: east, north, up, and of a body forward, left, up; their quaternion is
/// `enu_qw`. A name that is not known, or with a unit that is not, stays as it is.
Column column_named(std::string_view written);

}  // namespace drydock::score
