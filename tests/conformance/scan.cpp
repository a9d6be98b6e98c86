#include "tests/conformance/scan.hpp"

#include <charconv>

namespace drydock::conformance {

std::vector<std::string_view> scan_pd0(std::string_view bytes) {
  std::vector<std::string_view> found;
  std::size_t at = 0;
  while ((at = bytes.find("\x7F\x7F", at)) != bytes.npos && at + 4 <= bytes.size()) {
    const std::size_t length = pair_le(bytes, at + 2);
    bool good = length > 6 && at + length + 2 <= bytes.size();
    if (good) {
      std::uint16_t sum = 0;
      for (std::size_t i = at; i < at + length; ++i) sum += octet(bytes, i);
      good = sum == pair_le(bytes, at + length);
    }
    if (good) found.push_back(bytes.substr(at, length + 2));
    at += good ? length + 2 : 1;
  }
  return found;
}

namespace {

/// B58C and all bytes, of which every second one, and the last of an odd number, count 256 times.
unsigned ad2cp_sum(std::string_view bytes) {
  unsigned sum = 0xB58C;
  for (std::size_t i = 0; i < bytes.size(); ++i)
    sum += octet(bytes, i) * (i % 2 == 1 || i + 1 == bytes.size() ? 256 : 1);
  return sum & 0xFFFF;
}

/// Bytes of the sound record at the front, 0 if there is none.
std::size_t ad2cp_record_size(std::string_view bytes) {
  if (bytes.size() < 12) return 0;
  const std::size_t head = octet(bytes, 1);
  if (head != 10 && head != 12) return 0;
  const std::size_t data = pair_le(bytes, 4) + (head == 12 ? pair_le(bytes, 6) * 65536 : 0);
  if (bytes.size() < head + data) return 0;
  const bool good = ad2cp_sum(bytes.substr(0, head - 2)) == pair_le(bytes, head - 2) &&
                    ad2cp_sum(bytes.substr(head, data)) == pair_le(bytes, head - 4);
  return good ? head + data : 0;
}

}  // namespace

std::vector<std::string_view> scan_ad2cp(std::string_view bytes) {
  std::vector<std::string_view> found;
  for (std::size_t at = 0; (at = bytes.find('\xA5', at)) != bytes.npos;) {
    const std::size_t size = ad2cp_record_size(bytes.substr(at));
    if (size > 0) found.push_back(bytes.substr(at, size));
    at += size > 0 ? size : 1;
  }
  return found;
}

std::vector<std::string_view> scan_ubx(std::string_view bytes) {
  std::vector<std::string_view> found;
  std::size_t at = 0;
  while ((at = bytes.find("\xB5\x62", at)) != bytes.npos && at + 8 <= bytes.size()) {
    const std::size_t end = at + 6 + pair_le(bytes, at + 4);
    bool good = end + 2 <= bytes.size();
    if (good) {
      std::uint8_t a = 0, b = 0;
      for (std::size_t i = at + 2; i < end; ++i) b += a += octet(bytes, i);
      good = octet(bytes, end) == a && octet(bytes, end + 1) == b;
    }
    if (good) found.push_back(bytes.substr(at, end + 2 - at));
    at = good ? end + 2 : at + 1;
  }
  return found;
}

std::vector<std::string_view> scan_nmea(std::string_view bytes) {
  std::vector<std::string_view> found;
  for (std::size_t at = bytes.find('$'); at != bytes.npos; at = bytes.find('$', at + 1)) {
    unsigned sum = 0;
    std::size_t end = at + 1;
    for (; end < bytes.size() && bytes[end] >= ' ' && bytes[end] <= '~' && bytes[end] != '*' &&
           bytes[end] != '$';
         ++end)
      sum ^= octet(bytes, end);
    if (end + 2 >= bytes.size() || bytes[end] != '*') continue;
    unsigned said = 0;
    const char* digits = bytes.data() + end + 1;
    const auto parsed = std::from_chars(digits, digits + 2, said, 16);
    if (parsed.ptr == digits + 2 && said == sum) found.push_back(bytes.substr(at, end - at));
  }
  return found;
}

}  // namespace drydock::conformance
