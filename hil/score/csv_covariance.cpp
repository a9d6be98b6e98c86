#include "hil/score/csv_covariance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace drydock::score {
namespace {

constexpr std::size_t covariance_size = 6;

struct Written {
  std::string_view behind;  ///< the last words of a path
  const char* name;
};
constexpr std::array covariances_written{Written{"pose.covariance", csv_pose_covariance},
                                         Written{"twist.covariance", csv_twist_covariance}};

}  // namespace

std::string covariance_column(std::string_view of, std::size_t row, std::size_t column) {
  return fmt::format("{}_{}", of, covariance_size * row + column);
}

std::optional<std::string> covariance_named(std::string_view written) {
  std::string path = ".";
  for (const char c : written)
    if (c != ']' && c != ' ') path.push_back(c == '/' || c == '[' ? '.' : c);
  const std::size_t digits = path.find_last_not_of("0123456789") + 1;
  std::size_t place = 0;
  const auto [end, error] = std::from_chars(path.data() + digits, path.data() + path.size(), place);
  if (error != std::errc{} || place >= covariance_size * covariance_size) return {};
  std::string_view word = std::string_view(path).substr(0, digits);
  if (word.ends_with('.')) word.remove_suffix(1);
  for (const auto& covariance : covariances_written)
    if (word.ends_with(covariance.behind) &&
        word[word.size() - covariance.behind.size() - 1] == '.')
      return covariance_column(covariance.name, place / covariance_size, place % covariance_size);
  return {};
}

bool is_covariance_column(std::string_view name) {
  return name.starts_with(csv_pose_covariance) || name.starts_with(csv_twist_covariance);
}

}  // namespace drydock::score
