#include <array>
#include <charconv>
#include <cmath>

#include "drivers/measurement/units.hpp"
#include "hil/world/sky.hpp"

namespace drydock::world {
namespace {

using namespace std::chrono;

/// Removes digits and the separator after them from the front of the text.
std::optional<int> take(std::string_view& text, std::size_t digits, char separator) {
  int value = 0;
  if (text.size() < digits) return std::nullopt;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + digits, value);
  if (error != std::errc{} || rest != text.data() + digits || value < 0) return std::nullopt;
  text.remove_prefix(digits);
  if (separator != '\0') {
    if (!text.starts_with(separator)) return std::nullopt;
    text.remove_prefix(1);
  }
  return value;
}

/// Removes a number and the separator after it, if there is one, from the front of the text.
std::optional<double> take_number(std::string_view& text) {
  double value = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  if (!text.empty() && (text[0] != ',' || text.size() == 1)) return std::nullopt;
  text.remove_prefix(text.empty() ? 0 : 1);
  return value;
}

}  // namespace

std::optional<sky::GpsTime> parse_instant(std::string_view text) {
  const bool gps = text.ends_with(" GPS");
  if (gps) text.remove_suffix(4);
  if (!gps && text.ends_with('Z')) text.remove_suffix(1);
  const auto y = take(text, 4, '-'), mo = y ? take(text, 2, '-') : y;
  const auto d = mo ? take(text, 2, 'T') : mo, h = d ? take(text, 2, ':') : d;
  const auto mi = h ? take(text, 2, ':') : h;
  if (!mi || *y < 1980 || *y > 2199 || *h > 23 || *mi > 59) return std::nullopt;
  double second = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, second, std::chars_format::fixed);
  const year_month_day date{year{*y}, month{static_cast<unsigned>(*mo)},
                            day{static_cast<unsigned>(*d)}};
  if (error != std::errc{} || rest != end || !(second >= 0 && second < 60) || !date.ok())
    return std::nullopt;
  const auto of_day = hours{*h} + minutes{*mi} + measurement::from_seconds(second);
  if (gps) return sky::gps_time(date, of_day);
  return sky::gps_time(
      measurement::stamp_from_ns((sys_days{date}.time_since_epoch() + of_day).count()));
}

std::optional<frame::Position> parse_place(std::string_view text) {
  const auto latitude = take_number(text);
  const auto longitude = latitude && !text.empty() ? take_number(text) : std::nullopt;
  if (!longitude) return std::nullopt;
  const auto height = text.empty() ? std::optional{0.0} : take_number(text);
  if (!height || !text.empty() || std::abs(*latitude) > 90 || std::abs(*longitude) > 360 ||
      std::abs(*height) > 1e6)
    return std::nullopt;
  return frame::Position{*latitude * units::degree, *longitude * units::degree, *height};
}

}  // namespace drydock::world
