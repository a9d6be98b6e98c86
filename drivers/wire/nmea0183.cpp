#include "drivers/wire/nmea0183.hpp"

#include <algorithm>
#include <cstring>

namespace drydock::wire {
namespace {

constexpr int hex_value(std::uint8_t c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

constexpr std::uint32_t code(std::string_view formatter) {
  if (formatter.size() != 3) return 0;
  return static_cast<std::uint32_t>(formatter[0]) << 16 |
         static_cast<std::uint32_t>(formatter[1]) << 8 | static_cast<std::uint32_t>(formatter[2]);
}

/// The sentence and its checksum are sound up to `end`; how far does its line end reach?
Scan with_line_end(Bytes bytes, std::size_t end) {
  if (end == bytes.size()) return Scan::need_more();
  if (bytes[end] == '\n') return Scan::frame(end + 1);
  if (bytes[end] != '\r') return Scan::frame(end);
  if (end + 1 == bytes.size()) return Scan::need_more();
  return Scan::frame(bytes[end + 1] == '\n' ? end + 2 : end + 1);
}

/// `star` is where the checksum begins. Nothing before it can start another sentence.
Scan with_checksum(Bytes bytes, std::size_t star, std::uint8_t checksum) {
  int sent = 0;
  for (std::size_t i = star + 1; i < star + 3; ++i) {
    if (i == bytes.size()) return Scan::need_more();
    const int digit = hex_value(bytes[i]);
    if (digit < 0) return Scan::skip(i);
    sent = sent * 16 + digit;
  }
  return sent == checksum ? with_line_end(bytes, star + 3) : Scan::bad_checksum();
}

}  // namespace

Scan Nmea0183::scan(Bytes bytes) {
  if (bytes.empty()) return Scan::need_more();
  if (bytes[0] != '$') {
    const auto* start =
        static_cast<const std::uint8_t*>(std::memchr(bytes.data(), '$', bytes.size()));
    return Scan::skip(start ? static_cast<std::size_t>(start - bytes.data()) : bytes.size());
  }
  constexpr std::size_t tail = 5;  // *hh CR LF
  const std::size_t limit = std::min(bytes.size(), max_frame - tail + 1);
  std::uint8_t checksum = 0;
  for (std::size_t i = 1; i < limit; ++i) {
    const std::uint8_t c = bytes[i];
    if (c == '*') return with_checksum(bytes, i, checksum);
    if (c == '$' || c < 0x20 || c > 0x7e) return Scan::skip(i);
    checksum ^= c;
  }
  return limit < bytes.size() ? Scan::skip(1) : Scan::need_more();
}

std::optional<Nmea0183::Message> Nmea0183::decode(Bytes frame) {
  SentenceReader fields{frame};
  switch (code(fields.formatter())) {
    case code("GGA"): return read_gga(fields);
    case code("RMC"): return read_rmc(fields);
    case code("GSV"): return read_gsv(fields);
    case code("GSA"): return read_gsa(fields);
    case code("VTG"): return read_vtg(fields);
    case code("ZDA"): return read_zda(fields);
    case code("VHW"): return read_vhw(fields);
    case code("VBW"): return read_vbw(fields);
    case code("VLW"): return read_vlw(fields);
    default: return std::nullopt;
  }
}

}  // namespace drydock::wire
