#include "drivers/terminal/data_size.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace drydock::terminal {
namespace {

struct Unit {
  std::string_view name;
  double bytes;
};

/// IEC 80000-13 and SI.
constexpr std::array units{Unit{"KiB", 0x1p10}, Unit{"MiB", 0x1p20}, Unit{"GiB", 0x1p30},
                           Unit{"TiB", 0x1p40}, Unit{"kB", 1e3},     Unit{"MB", 1e6},
                           Unit{"GB", 1e9},     Unit{"TB", 1e12}};

}  // namespace

std::optional<std::uint64_t> parse_data_size(std::string_view text) {
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  const std::string_view name(rest, static_cast<std::size_t>(text.data() + text.size() - rest));
  for (const auto& unit : units)
    if (const double bytes = value * unit.bytes; unit.name == name && bytes >= 1 && bytes < 0x1p63)
      return static_cast<std::uint64_t>(bytes);
  return std::nullopt;
}

std::string no_data_size(std::string_view text) {
  return fmt::format("'{}' is no size; allowed: 512MiB, 20GiB, 1.5TB", text);
}

std::string data_size_text(std::uint64_t bytes) {
  const auto size = static_cast<double>(bytes);
  if (bytes < 1000) return fmt::format("{} B", bytes);
  if (size < 999.5e3) return fmt::format("{:.0f} kB", size / 1e3);
  if (size < 999.95e6) return fmt::format("{:.1f} MB", size / 1e6);
  return fmt::format("{:.1f} GB", size / 1e9);
}

}  // namespace drydock::terminal
