#include "drivers/wire/ubx/ubx_nmea.hpp"

#include <cstring>

#include "drivers/wire/nmea0183/nmea0183_decode.hpp"
#include "drivers/wire/ubx/rtcm3.hpp"
#include "drivers/wire/ubx/ubx_decode.hpp"

namespace drydock::wire {
namespace {

/// Number of bytes before the next `$`, `!`, B5 or D3; all bytes if there is none.
std::size_t noise_in(Bytes bytes) {
  const auto find = [](Bytes part, int byte) {
    const auto* at = static_cast<const std::uint8_t*>(std::memchr(part.data(), byte, part.size()));
    return at ? static_cast<std::size_t>(at - part.data()) : part.size();
  };
  const std::size_t to_sentence = find(bytes.first(find(bytes, '$')), '!');
  const std::size_t to_ubx = find(bytes.first(to_sentence), ubx::sync_1);
  return find(bytes.first(to_ubx), rtcm3::preamble);
}

}  // namespace

Scan scan_ubx_or_nmea(Bytes bytes) {
  if (bytes.empty()) return Scan::need_more();
  if (bytes[0] == '$' || bytes[0] == '!') return Nmea0183::scan(bytes);
  if (bytes[0] == rtcm3::preamble) return rtcm3::scan(bytes);
  if (bytes[0] != ubx::sync_1) return Scan::skip(noise_in(bytes));
  if (bytes.size() > 1 && bytes[1] != ubx::sync_2) return Scan::skip(1);
  return Ubx::scan(bytes);
}

std::optional<UbxNmea::Message> UbxNmea::decode(Bytes frame) {
  if (frame.empty()) return std::nullopt;
  if (frame[0] == '$' || frame[0] == '\\') return decode_nmea0183<Message>(frame);
  if (frame[0] == rtcm3::preamble || frame[0] == '!') return std::nullopt;
  return decode_ubx<Message>(frame);
}

}  // namespace drydock::wire
