#include "drivers/wire/dvl/water_linked.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "drivers/wire/crc.hpp"
#include "drivers/wire/hex.hpp"
#include "drivers/wire/line_end.hpp"
#include "drivers/wire/text_bytes.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::wire {
namespace {

using namespace water_linked;

constexpr std::size_t head_size = 3, checksum_size = 3, line_end_size = 2;

/// What needs no look inside a frame: printable, no checksum's star, no start of another frame.
constexpr auto plain = [] {
  std::array<bool, 256> all{};
  for (unsigned c = 0x20; c <= 0x7e; ++c) all[c] = c != '*' && c != 'w';
  return all;
}();

constexpr Crc checksum{{.width = 8, .polynomial = 0x07}};

constexpr bool ends_line(std::uint8_t c) { return c == '\r' || c == '\n'; }

Scan with_checksum(Bytes bytes, std::size_t star) {
  if (bytes.size() < star + checksum_size) return Scan::need_more();
  const auto sent = parse_hex(as_text(bytes.subspan(star + 1, 2)));
  if (!sent) return Scan::skip(1);
  return *sent == crc8(as_text(bytes.first(star))) ? with_line_end(bytes, star + checksum_size)
                                                   : Scan::bad_checksum();
}

/// True if the bytes may begin a frame: `w`, direction, name. Then follow options, a checksum or,
/// for a command, the line's end.
bool may_begin(Bytes bytes) {
  const bool command = bytes.size() > 1 && bytes[1] == 'c';
  if (bytes.size() > 1 && !command && bytes[1] != 'r') return false;
  if (bytes.size() > 2 && (bytes[2] <= 0x20 || bytes[2] > 0x7e || bytes[2] == '*')) return false;
  if (bytes.size() <= head_size) return true;
  return bytes[3] == ',' || bytes[3] == '*' || (command && ends_line(bytes[3]));
}

/// A response inside a line means that the line before it was torn. Without this check, one joined
/// line of 256 has a valid CRC-8.
bool begins_response(Bytes bytes) {
  return bytes.size() > head_size && bytes[1] == 'r' && may_begin(bytes);
}

}  // namespace

Scan WaterLinked::scan(Bytes bytes) {
  if (bytes.empty()) return Scan::need_more();
  if (bytes[0] != 'w') {
    const void* const start = std::memchr(bytes.data(), 'w', bytes.size());
    return Scan::skip(
        start ? static_cast<std::size_t>(static_cast<const std::uint8_t*>(start) - bytes.data())
              : bytes.size());
  }
  if (!may_begin(bytes)) return Scan::skip(1);
  const std::size_t limit = std::min(bytes.size(), max_frame - checksum_size - line_end_size + 1);
  for (std::size_t i = head_size; i < limit; ++i) {
    const std::uint8_t c = bytes[i];
    if (plain[c]) continue;
    if (c == '*') return with_checksum(bytes, i);
    if (bytes[1] == 'c' && ends_line(c)) return with_line_end(bytes, i);
    if (c < 0x20 || c > 0x7e) return Scan::skip(1);
    if (c == 'w' && begins_response(bytes.subspan(i))) return Scan::skip(i);
  }
  return limit < bytes.size() ? Scan::skip(1) : Scan::need_more();
}

namespace water_linked {

std::uint8_t crc8(std::string_view text) {
  return static_cast<std::uint8_t>(checksum(bytes_of(text)));
}

}  // namespace water_linked
}  // namespace drydock::wire
