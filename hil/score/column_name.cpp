#include "hil/score/column_name.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <numbers>
#include <optional>
#include <utility>

#include "hil/score/csv_covariance.hpp"

namespace drydock::score {
namespace {

enum class Kind { number, length, angle, speed, place, time };

struct Other {
  std::string_view written;
  const char* name;
  Kind kind = Kind::number;
  double factor = 1;
};

/// These may have the path of a message in front: ROS and its exporters write it.
constexpr std::array in_messages{Other{"position.x", "east_m", Kind::length},
                                 Other{"position.y", "north_m", Kind::length},
                                 Other{"position.z", "down_m", Kind::length, -1},
                                 Other{"orientation.w", "enu_qw"},
                                 Other{"orientation.x", "enu_qx"},
                                 Other{"orientation.y", "enu_qy"},
                                 Other{"orientation.z", "enu_qz"},
                                 Other{"twist.linear.x", "body_forward_mps", Kind::speed},
                                 Other{"twist.linear.y", "body_right_mps", Kind::speed, -1},
                                 Other{"twist.linear.z", "body_down_mps", Kind::speed, -1},
                                 Other{"latitude", "latitude_deg", Kind::place},
                                 Other{"longitude", "longitude_deg", Kind::place},
                                 Other{"altitude", "height_m", Kind::length},
                                 Other{"stamp.sec", csv_second},
                                 Other{"stamp.secs", csv_second},
                                 Other{"stamp.nanosec", csv_nanosecond},
                                 Other{"stamp.nsec", csv_nanosecond},
                                 Other{"stamp.nsecs", csv_nanosecond},
                                 Other{"header.stamp", csv_stamp, Kind::time}};

/// EuRoC's ground truth (R is the reference frame, S the sensor), and what people write.
constexpr std::array alone{Other{"p_rs_r_x", "east_m", Kind::length},
                           Other{"p_rs_r_y", "north_m", Kind::length},
                           Other{"p_rs_r_z", "down_m", Kind::length, -1},
                           Other{"q_rs_w", "enu_qw"},
                           Other{"q_rs_x", "enu_qx"},
                           Other{"q_rs_y", "enu_qy"},
                           Other{"q_rs_z", "enu_qz"},
                           Other{"v_rs_r_x", "velocity_east_mps", Kind::speed},
                           Other{"v_rs_r_y", "velocity_north_mps", Kind::speed},
                           Other{"v_rs_r_z", "velocity_down_mps", Kind::speed, -1},
                           Other{"x", "east_m", Kind::length},
                           Other{"y", "north_m", Kind::length},
                           Other{"z", "down_m", Kind::length, -1},
                           Other{"tx", "east_m", Kind::length},
                           Other{"ty", "north_m", Kind::length},
                           Other{"tz", "down_m", Kind::length, -1},
                           Other{"q_w", "qw"},
                           Other{"q_x", "qx"},
                           Other{"q_y", "qy"},
                           Other{"q_z", "qz"},
                           Other{"north", "north_m", Kind::length},
                           Other{"east", "east_m", Kind::length},
                           Other{"down", "down_m", Kind::length},
                           Other{"up", "down_m", Kind::length, -1},
                           Other{"lat", "latitude_deg", Kind::place},
                           Other{"lon", "longitude_deg", Kind::place},
                           Other{"lng", "longitude_deg", Kind::place},
                           Other{"long", "longitude_deg", Kind::place},
                           Other{"alt", "height_m", Kind::length},
                           Other{"height", "height_m", Kind::length},
                           Other{"ele", "height_m", Kind::length},
                           Other{"elevation", "height_m", Kind::length},
                           Other{"roll", "roll_deg", Kind::angle},
                           Other{"pitch", "pitch_deg", Kind::angle},
                           Other{"yaw", "heading_deg", Kind::angle},
                           Other{"heading", "heading_deg", Kind::angle},
                           Other{"vn", "velocity_north_mps", Kind::speed},
                           Other{"ve", "velocity_east_mps", Kind::speed},
                           Other{"vd", "velocity_down_mps", Kind::speed},
                           Other{"vel_n", "velocity_north_mps", Kind::speed},
                           Other{"vel_e", "velocity_east_mps", Kind::speed},
                           Other{"vel_d", "velocity_down_mps", Kind::speed},
                           Other{"timestamp", csv_time, Kind::time},
                           Other{"time", csv_time, Kind::time},
                           Other{"time_utc", csv_time, Kind::time},
                           Other{"utc_time", csv_time, Kind::time},
                           Other{"datetime", csv_time, Kind::time},
                           Other{"t", csv_time, Kind::time},
                           Other{"stamp", csv_stamp, Kind::time}};

/// The names of `drydock track`, and second names of this program's.
constexpr std::array own_names{
    Other{"yaw_deg", "heading_deg"},         Other{"altitude_m", "height_m"},
    Other{"sigma_north_m", "north_sigma_m"}, Other{"sigma_east_m", "east_sigma_m"},
    Other{"sigma_height_m", "down_sigma_m"}, Other{"sigma_heading_deg", "heading_sigma_deg"}};

struct CsvUnit {
  std::string_view written;
  Kind kind;
  double factor;
};

constexpr double degrees_of_rad = 180 / std::numbers::pi;
constexpr double mps_of_knot = 1852. / 3600;
constexpr std::array csv_units{CsvUnit{"m", Kind::length, 1},
                               CsvUnit{"cm", Kind::length, 1e-2},
                               CsvUnit{"mm", Kind::length, 1e-3},
                               CsvUnit{"km", Kind::length, 1e3},
                               CsvUnit{"ft", Kind::length, 0.3048},
                               CsvUnit{"deg", Kind::angle, 1},
                               CsvUnit{"degree", Kind::angle, 1},
                               CsvUnit{"degrees", Kind::angle, 1},
                               CsvUnit{"\xC2\xB0", Kind::angle, 1},
                               CsvUnit{"rad", Kind::angle, degrees_of_rad},
                               CsvUnit{"radians", Kind::angle, degrees_of_rad},
                               CsvUnit{"m/s", Kind::speed, 1},
                               CsvUnit{"mps", Kind::speed, 1},
                               CsvUnit{"m_s^-1", Kind::speed, 1},
                               CsvUnit{"cm/s", Kind::speed, 1e-2},
                               CsvUnit{"mm/s", Kind::speed, 1e-3},
                               CsvUnit{"km/h", Kind::speed, 1 / 3.6},
                               CsvUnit{"kn", Kind::speed, mps_of_knot},
                               CsvUnit{"kt", Kind::speed, mps_of_knot},
                               CsvUnit{"knots", Kind::speed, mps_of_knot}};

struct TimeUnit {
  std::string_view written;
  const char* name;
};

constexpr std::array time_units{TimeUnit{"ns", "valid_at_ns"},    TimeUnit{"us", csv_microseconds},
                                TimeUnit{"ms", csv_milliseconds}, TimeUnit{"s", "t_s"},
                                TimeUnit{"sec", "t_s"},           TimeUnit{"secs", "t_s"},
                                TimeUnit{"seconds", "t_s"},       TimeUnit{"utc", "utc"}};

struct Parts {
  std::string name, unit;
};

/// Small letters; blanks are `_`, and the signs in front of a name (`#`, `%`, `/`, `__`) go.
std::string plain(std::string_view written) {
  std::string out;
  for (const char c : written)
    out.push_back(c == ' ' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
  const auto first = out.find_first_not_of("#%/._");
  const auto last = out.find_last_not_of('_');
  return first == std::string::npos ? std::string{} : out.substr(first, last + 1 - first);
}

std::optional<Parts> with_bracket(const std::string& text) {
  const auto open = text.find_first_of("[(");
  if (open == std::string::npos || (text.back() != ']' && text.back() != ')')) return {};
  return Parts{plain(text.substr(0, open)), text.substr(open + 1, text.size() - open - 2)};
}

/// A path has points: `/odom/pose/pose/position/x` is a message's too.
const Other* other_named(std::string name) {
  if (const auto found = std::ranges::find(alone, name, &Other::written); found != alone.end())
    return &*found;
  std::ranges::replace(name, '/', '.');
  name.insert(0, 1, '.');
  for (const Other& other : in_messages)
    if (name.ends_with(other.written) && name[name.size() - other.written.size() - 1] == '.')
      return &other;
  return nullptr;
}

std::optional<Column> with_unit(const Parts& parts) {
  const Other* other = other_named(parts.name);
  if (other == nullptr) return {};
  if (other->kind == Kind::time) {
    if (parts.unit.empty()) return Column{other->name};
    const auto unit = std::ranges::find(time_units, parts.unit, &TimeUnit::written);
    return unit == time_units.end() ? std::nullopt : std::optional(Column{unit->name});
  }
  // Degrees and radians are both usual for an angle, so that one without a unit is none; a place
  // without one is in degrees.
  if (parts.unit.empty())
    return other->kind == Kind::angle ? std::nullopt
                                      : std::optional(Column{other->name, other->factor});
  const Kind kind = other->kind == Kind::place ? Kind::angle : other->kind;
  for (const CsvUnit& unit : csv_units)
    if (unit.written == parts.unit && unit.kind == kind)
      return Column{other->name, other->factor * unit.factor};
  return {};
}

}  // namespace

Column column_named(std::string_view written) {
  for (const Other& other : own_names)
    if (other.written == written) return {other.name};
  if (auto covariance = covariance_named(written)) return {std::move(*covariance)};
  const std::string text = plain(written);
  if (text.empty()) return {std::string(written)};
  auto column = with_unit(with_bracket(text).value_or(Parts{text, {}}));
  if (const auto at = text.rfind('_'); !column && at != std::string::npos)
    column = with_unit({text.substr(0, at), text.substr(at + 1)});
  return column.value_or(Column{std::string(written)});
}

}  // namespace drydock::score
