#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace drydock::score {

/// Columns that mean something only together.
using CsvGroup = std::array<const char*, 3>;
inline constexpr CsvGroup csv_geodetic{"latitude_deg", "longitude_deg", "height_m"};
inline constexpr CsvGroup csv_local{"north_m", "east_m", "down_m"};
inline constexpr CsvGroup csv_angles{"roll_deg", "pitch_deg", "heading_deg"};
inline constexpr CsvGroup csv_sigmas{"north_sigma_m", "east_sigma_m", "down_sigma_m"};

/// Some programs of Windows begin a text with it.
inline std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.substr(text.starts_with(mark) ? mark.size() : 0);
}

/// The cells of a line, without blanks and quotation marks.
std::vector<std::string> csv_cells(std::string_view line);

/// The first line of a CSV file: the names of its columns.
class CsvHead {
 public:
  explicit CsvHead(std::string_view line);

  std::size_t size() const { return names_.size(); }
  bool has(std::string_view name) const;
  bool has(const CsvGroup& group) const;
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
