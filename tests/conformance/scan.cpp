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
