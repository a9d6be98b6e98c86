#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "hil/score/column_name.hpp"

namespace drydock::score {

/// Columns of one kind, along three axes.
using CsvGroup = std::array<const char*, 3>;
inline constexpr std::array csv_times{"valid_at_ns", "t_s", "utc"};  ///< the first one counts
/// Of others' files, where there is none of these; the first one counts.
inline constexpr std::array csv_other_times{csv_second,       csv_nanosecond,   csv_stamp,
                                            csv_milliseconds, csv_microseconds, csv_time};
inline constexpr CsvGroup csv_geodetic{"latitude_deg", "longitude_deg", "height_m"};
inline constexpr CsvGroup csv_local{"north_m", "east_m", "down_m"};
inline constexpr CsvGroup csv_angles{"roll_deg", "pitch_deg", "heading_deg"};
inline constexpr CsvGroup csv_velocity{"velocity_north_mps", "velocity_east_mps",
                                       "velocity_down_mps"};
inline constexpr CsvGroup csv_body_velocity{"body_forward_mps", "body_right_mps", "body_down_mps"};
inline constexpr CsvGroup csv_local_sigmas{"north_sigma_m", "east_sigma_m", "down_sigma_m"};
inline constexpr CsvGroup csv_angle_sigmas{"roll_sigma_deg", "pitch_sigma_deg",
                                           "heading_sigma_deg"};
inline constexpr CsvGroup csv_velocity_sigmas{"velocity_north_sigma_mps", "velocity_east_sigma_mps",
                                              "velocity_down_sigma_mps"};
inline constexpr CsvGroup csv_body_velocity_sigmas{"body_forward_sigma_mps", "body_right_sigma_mps",
                                                   "body_down_sigma_mps"};
inline constexpr std::array csv_quaternion{"qw", "qx", "qy", "qz"};

/// The same of axes east, north, up and of a body forward, left, up (REP-103).
inline constexpr std::array csv_enu_quaternion{"enu_qw", "enu_qx", "enu_qy", "enu_qz"};

/// The correlation of north and east, beside their standard deviations.
inline constexpr const char* csv_correlation = "correlation_north_east";

/// The names of a CSV file's columns, also as other programs write them (column_name.hpp).
class CsvHead {
 public:
  explicit CsvHead(std::vector<std::string> written);

  std::size_t size() const { return columns_.size(); }
  bool has(std::string_view name) const;
  bool has_any(const CsvGroup& group) const;
  bool has_quaternion() const;
  bool has_enu_quaternion() const;
  /// Latitude and longitude mean something only together.
  bool has_geodetic() const { return has(csv_geodetic[0]) && has(csv_geodetic[1]); }
  /// The place of a column that is there.
  std::size_t at(std::string_view name) const;
  /// What its numbers are multiplied with.
  double factor(std::string_view name) const { return columns_[at(name)].factor; }
  /// Why no estimates can be read; empty: they can.
  std::string misfit() const;
  /// Columns that are passed over, because others of their group are not there, or nobody knows
  /// their names; and how those were taken that leave it open.
  std::vector<std::string> notes() const;

 private:
  std::vector<std::string> unknown() const;

  std::vector<std::string> written_;
  std::vector<Column> columns_;
};

}  // namespace drydock::score
