#include "drivers/capture/text_line.hpp"

#include <algorithm>
#include <optional>

#include "drivers/wire/dvl/water_linked.hpp"

namespace drydock::capture {
namespace {

bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
bool is_lower(char c) { return c >= 'a' && c <= 'z'; }

std::optional<unsigned> digit(char c) {
  constexpr std::string_view upper = "0123456789ABCDEF", lower = "0123456789abcdef";
  const auto at = std::min(upper.find(c), lower.find(c));
  return at == upper.npos ? std::nullopt : std::optional(static_cast<unsigned>(at));
}

unsigned checksum_of(std::string_view line, TextLine kind) {
  if (kind == TextLine::water_linked) return wire::water_linked::crc8(line);
  unsigned sum = 0;
  for (const char c : line.substr(1)) sum ^= static_cast<std::uint8_t>(c);
  return sum;
}

/// At most one character, or Docklight's `<CR><LF>`.
bool is_mark_of_logger(std::string_view behind) {
  return behind.size() <= 1 || (behind.starts_with('<') && behind.ends_with('>'));
}

bool has_right_checksum(std::string_view line, TextLine kind) {
  const auto star = line.find('*');
  if (star == line.npos || star + 3 > line.size() || !is_mark_of_logger(line.substr(star + 3)))
    return false;
  const auto high = digit(line[star + 1]), low = digit(line[star + 2]);
  return high && low && checksum_of(line.substr(0, star), kind) == *high * 16 + *low;
}

}  // namespace

std::size_t begin_behind(std::string_view text, TextLine kind) {
  constexpr std::size_t named = 4;  // `wrx,` and `:SA,`
  const auto last = text.size() >= named ? text.substr(text.size() - named) : std::string_view{};
  switch (kind) {
    case TextLine::sentence: return text.ends_with('$') || text.ends_with('!') ? 1 : 0;
    case TextLine::water_linked:
      return last.starts_with("wr") && is_lower(last[2]) && last[3] == ',' ? named : 0;
    case TextLine::pd6:
      return last.starts_with(':') && is_upper(last[1]) && is_upper(last[2]) && last[3] == ','
                 ? named
                 : 0;
    case TextLine::json: return text.ends_with("{\"") ? 2 : 0;
  }
  return 0;
}

bool is_whole(std::string_view line, TextLine kind) {
  if (has_checksum(kind)) return has_right_checksum(line, kind);
  return kind == TextLine::pd6 || line.ends_with('}');
}

bool has_checksum(TextLine kind) {
  return kind == TextLine::sentence || kind == TextLine::water_linked;
}

}  // namespace drydock::capture
