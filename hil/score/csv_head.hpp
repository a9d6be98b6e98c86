#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace drydock::score {

/// Columns of one kind, along three axes.
using CsvGroup = std::array<const char*, 3>;
inline constexpr std::array csv_times{"valid_at_ns", "t_s", "utc"};  ///< the first one counts
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

/// Some programs of Windows begin a text with it.
inline std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.substr(text.starts_with(mark) ? mark.size() : 0);
}

/// The cells of a line, without blanks and quotation marks.
std::vector<std::string> csv_cells(std::string_view line);

/// The correlation of north and east, beside their standard deviations.
inline constexpr const char* csv_correlation = "correlation_north_east";

/// The first line of a CSV file: the names of its columns. `yaw_deg` is `heading_deg`, `altitude_m`
/// is `height_m`, and the standard deviations may have the names of `drydock track`
/// (`sigma_north_m`).
class CsvHead {
 public:
  explicit CsvHead(std::string_view line);

  std::size_t size() const { return names_.size(); }
  bool has(std::string_view name) const;
  bool has_any(const CsvGroup& group) const;
  bool has_quaternion() const;
  /// Latitude and longitude mean something only together.
  bool has_geodetic() const { return has(csv_geodetic[0]) && has(csv_geodetic[1]); }
  /// The place of a column that is there.
  std::size_t at(std::string_view name) const;
  /// Why no estimates can be read; empty: they can.
  std::string misfit() const;
  /// Columns that are passed over, because others of their group are not there.
  std::vector<std::string> incomplete() const;

 private:
  std::vector<std::string> names_;
};

}  // namespace drydock::score
