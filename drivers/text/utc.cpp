#include "drivers/text/utc.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <string>

namespace drydock::text {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

std::optional<measurement::Stamp> parse_utc(std::string_view text) {
  constexpr std::string_view pattern = "dddd-dd-ddTdd:dd:dd";
  if (text.size() <= pattern.size() || text.back() != 'Z') return {};
  for (std::size_t i = 0; i < pattern.size(); ++i)
    if (pattern[i] == 'd' ? !is_digit(text[i]) : text[i] != pattern[i]) return {};
  const auto number = [&](std::size_t at, std::size_t size) {
    int value = 0;
    std::from_chars(text.data() + at, text.data() + at + size, value);
    return value;
  };
  std::string fraction(text.substr(pattern.size(), text.size() - pattern.size() - 1));
  if (fraction.empty()) fraction = ".0";
  if (fraction[0] != '.' || fraction.size() < 2 || fraction.size() > 10 ||
      !std::all_of(fraction.begin() + 1, fraction.end(), is_digit))
    return {};
  fraction.resize(10, '0');
  const std::chrono::year_month_day date{std::chrono::year{number(0, 4)},
                                         std::chrono::month{static_cast<unsigned>(number(5, 2))},
                                         std::chrono::day{static_cast<unsigned>(number(8, 2))}};
  if (!date.ok() || number(11, 2) > 23 || number(14, 2) > 59 || number(17, 2) > 59) return {};
  int ns = 0;
  std::from_chars(fraction.data() + 1, fraction.data() + fraction.size(), ns);
  return measurement::Stamp{std::chrono::sys_days{date}.time_since_epoch() +
                            std::chrono::hours{number(11, 2)} +
                            std::chrono::minutes{number(14, 2)} +
                            std::chrono::seconds{number(17, 2)} + std::chrono::nanoseconds{ns}};
}

}  // namespace drydock::text
