#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string_view>

#include "drivers/measurement/kind.hpp"
#include "drivers/measurement/units.hpp"

/// What a field of a described message can be: the fields of the measurements, and the times.
namespace drydock::wire::described {

using measurement::Kind;

/// The exponents of length, time, mass, angle and temperature; a date is none of them.
struct Dimension {
  std::int8_t length = 0, time = 0, mass = 0, angle = 0, temperature = 0, date = 0;
  friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
};

namespace dimension {
inline constexpr Dimension none{}, length{1}, time{0, 1}, speed{1, -1}, acceleration{1, -2},
    variance{2, -2}, pressure{-1, -2, 1}, angle{0, 0, 0, 1}, turn_rate{0, -1, 0, 1},
    temperature{0, 0, 0, 0, 1}, date{0, 0, 0, 0, 0, 1};
}  // namespace dimension

enum class Target : std::uint8_t {
  time,
  valid_at,
  sent_at,
  age,
  date,
  interval,
  depth,
  pressure,
  sea_pressure,
  temperature,
  altitude,
  forward,
  starboard,
  down,
  error_velocity,
  range_1,
  range_2,
  range_3,
  range_4,
  heading,
  magnetic_heading,
  heading_reference,
  deviation,
  variation,
  pitch,
  roll,
  rate_of_turn,
  quaternion_w,
  quaternion_x,
  quaternion_y,
  quaternion_z,
  enu_quaternion_w,
  enu_quaternion_x,
  enu_quaternion_y,
  enu_quaternion_z,
  sound_speed,
  figure_of_merit,
  covariance_xx,
  covariance_xy,
  covariance_xz,
  covariance_yx,
  covariance_yy,
  covariance_yz,
  covariance_zx,
  covariance_zy,
  covariance_zz,
  longitudinal,
  transverse,
  distance,
  force_x,
  force_y,
  force_z,
  rate_x,
  rate_y,
  rate_z,
  latitude,
  longitude,
  ellipsoidal_height,
  sea_level_height,
  north,
  east,
  ground_speed,
  course,
  horizontal_accuracy,
  vertical_accuracy,
  speed_accuracy,
  dilution,
  satellites_used,
  utc,
  rudder,
  stern_plane,
  bow_plane,
  propeller
};

/// The kinds of sensor that have a target, as bits.
constexpr unsigned bit_of(Kind kind) { return 1u << static_cast<unsigned>(kind); }

struct TargetRow {
  Target target;
  std::string_view name;  ///< `field` in a description, and the key in `drydock decode`
  unsigned kinds;
  Dimension dimension;
  double shown = 1;  ///< SI value of one unit of the name
};

namespace kinds_with {
inline constexpr unsigned depth = bit_of(Kind::depth), dvl = bit_of(Kind::dvl),
                          emlog = bit_of(Kind::emlog), imu = bit_of(Kind::imu),
                          gnss = bit_of(Kind::gnss), actuator = bit_of(Kind::actuator),
                          attitude = bit_of(Kind::attitude), all = 127;
}  // namespace kinds_with

inline constexpr auto target_rows = [] {
  using enum Target;
  namespace d = dimension;
  namespace k = kinds_with;
  constexpr double degree = units::degree;
  return std::to_array<TargetRow>({
      {time, "time_s", k::all, d::time},
      {valid_at, "valid_at_s", k::all, d::time},
      {sent_at, "sent_at_s", k::all, d::time},
      {age, "age_s", k::all, d::time},
      {date, "date_s", k::all, d::date},
      {interval, "interval_s", k::all, d::time},
      {depth, "depth_m", k::depth, d::length},
      {pressure, "pressure_pa", k::depth, d::pressure},
      {sea_pressure, "sea_pressure_pa", k::depth, d::pressure},
      {temperature, "temperature_k", k::depth, d::temperature},
      {altitude, "altitude_m", k::depth | k::dvl, d::length},
      {forward, "forward_mps", k::dvl, d::speed},
      {starboard, "starboard_mps", k::dvl, d::speed},
      {down, "down_mps", k::dvl | k::gnss, d::speed},
      {error_velocity, "error_velocity_mps", k::dvl, d::speed},
      {range_1, "range_1_m", k::dvl, d::length},
      {range_2, "range_2_m", k::dvl, d::length},
      {range_3, "range_3_m", k::dvl, d::length},
      {range_4, "range_4_m", k::dvl, d::length},
      {heading, "heading_deg", k::dvl | k::attitude, d::angle, degree},
      {magnetic_heading, "magnetic_heading_deg", k::attitude, d::angle, degree},
      {heading_reference, "heading_reference", k::attitude, d::none},
      {deviation, "deviation_deg", k::attitude, d::angle, degree},
      {variation, "variation_deg", k::attitude, d::angle, degree},
      {pitch, "pitch_deg", k::dvl | k::attitude, d::angle, degree},
      {roll, "roll_deg", k::dvl | k::attitude, d::angle, degree},
      {rate_of_turn, "rate_of_turn_degps", k::attitude, d::turn_rate, degree},
      {quaternion_w, "quaternion_w", k::attitude, d::none},
      {quaternion_x, "quaternion_x", k::attitude, d::none},
      {quaternion_y, "quaternion_y", k::attitude, d::none},
      {quaternion_z, "quaternion_z", k::attitude, d::none},
      {enu_quaternion_w, "enu_quaternion_w", k::attitude, d::none},
      {enu_quaternion_x, "enu_quaternion_x", k::attitude, d::none},
      {enu_quaternion_y, "enu_quaternion_y", k::attitude, d::none},
      {enu_quaternion_z, "enu_quaternion_z", k::attitude, d::none},
      {sound_speed, "sound_speed_mps", k::dvl, d::speed},
      {figure_of_merit, "figure_of_merit_mps", k::dvl, d::speed},
      {covariance_xx, "covariance_xx_m2ps2", k::dvl, d::variance},
      {covariance_xy, "covariance_xy_m2ps2", k::dvl, d::variance},
      {covariance_xz, "covariance_xz_m2ps2", k::dvl, d::variance},
      {covariance_yx, "covariance_yx_m2ps2", k::dvl, d::variance},
      {covariance_yy, "covariance_yy_m2ps2", k::dvl, d::variance},
      {covariance_yz, "covariance_yz_m2ps2", k::dvl, d::variance},
      {covariance_zx, "covariance_zx_m2ps2", k::dvl, d::variance},
      {covariance_zy, "covariance_zy_m2ps2", k::dvl, d::variance},
      {covariance_zz, "covariance_zz_m2ps2", k::dvl, d::variance},
      {longitudinal, "longitudinal_mps", k::emlog, d::speed},
      {transverse, "transverse_mps", k::emlog, d::speed},
      {distance, "distance_m", k::emlog, d::length},
      {force_x, "force_x_mps2", k::imu, d::acceleration},
      {force_y, "force_y_mps2", k::imu, d::acceleration},
      {force_z, "force_z_mps2", k::imu, d::acceleration},
      {rate_x, "rate_x_degps", k::imu, d::turn_rate, degree},
      {rate_y, "rate_y_degps", k::imu, d::turn_rate, degree},
      {rate_z, "rate_z_degps", k::imu, d::turn_rate, degree},
      {latitude, "latitude_deg", k::gnss, d::angle, degree},
      {longitude, "longitude_deg", k::gnss, d::angle, degree},
      {ellipsoidal_height, "ellipsoidal_height_m", k::gnss, d::length},
      {sea_level_height, "mean_sea_level_height_m", k::gnss, d::length},
      {north, "north_mps", k::gnss, d::speed},
      {east, "east_mps", k::gnss, d::speed},
      {ground_speed, "ground_speed_mps", k::gnss, d::speed},
      {course, "course_deg", k::gnss, d::angle, degree},
      {horizontal_accuracy, "horizontal_accuracy_m", k::gnss, d::length},
      {vertical_accuracy, "vertical_accuracy_m", k::gnss, d::length},
      {speed_accuracy, "speed_accuracy_mps", k::gnss, d::speed},
      {dilution, "position_dop", k::gnss, d::none},
      {satellites_used, "satellites_used", k::gnss, d::none},
      {utc, "utc_s", k::gnss, d::time},
      {rudder, "rudder_deg", k::actuator, d::angle, degree},
      {stern_plane, "stern_plane_deg", k::actuator, d::angle, degree},
      {bow_plane, "bow_plane_deg", k::actuator, d::angle, degree},
      {propeller, "propeller_radps", k::actuator, d::turn_rate},
  });
}();

constexpr std::size_t index_of(Target target) { return static_cast<std::size_t>(target); }

using TargetSet = std::bitset<target_rows.size()>;

constexpr const TargetRow& row_of(Target target) { return target_rows[index_of(target)]; }

/// True for an angle that is the same after a whole turn.
constexpr bool is_circular(Target target) {
  using enum Target;
  return target == heading || target == magnetic_heading || target == course || target == longitude;
}

/// The first six targets are times: they measure nothing.
constexpr bool is_time(Target target) { return target <= Target::interval; }

/// Values of targets in SI units and radians.
class Readings {
 public:
  void clear() { present_.reset(); }
  bool has(Target target) const { return present_[index_of(target)]; }
  void set(Target target, double si) {
    values_[index_of(target)] = si;
    present_[index_of(target)] = true;
  }
  void set(Target target, const std::optional<double>& si) {
    if (si) set(target, *si);
  }
  std::optional<double> get(Target target) const {
    return has(target) ? std::optional(values_[index_of(target)]) : std::nullopt;
  }
  /// Removes all that was measured; the times stay.
  void keep_times() { present_ &= times; }
  void forget_times() { present_ &= ~times; }
  bool measured() const { return (present_ & ~times).any(); }

 private:
  static constexpr TargetSet times{(1u << (index_of(Target::interval) + 1)) - 1};

  std::array<double, target_rows.size()> values_{};
  TargetSet present_;
};

}  // namespace drydock::wire::described
