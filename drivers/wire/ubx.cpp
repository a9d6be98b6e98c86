#include "drivers/wire/ubx.hpp"

#include <cstring>

#include "drivers/wire/ubx_frame.hpp"

namespace drydock::wire {
namespace {

/// Bytes before the next B5 that is, or may become, a sync.
std::size_t distance_to_sync(Bytes bytes) {
  const std::uint8_t* at = bytes.data();
  const std::uint8_t* const end = at + bytes.size();
  while (at != end) {
    at = static_cast<const std::uint8_t*>(
        std::memchr(at, ubx::sync_1, static_cast<std::size_t>(end - at)));
    if (!at) return bytes.size();
    if (at + 1 == end || at[1] == ubx::sync_2) break;
    ++at;
  }
  return static_cast<std::size_t>(at - bytes.data());
}

template <class M>
std::optional<Ubx::Message> as_message(const std::optional<M>& m) {
  return m ? std::optional<Ubx::Message>{*m} : std::nullopt;
}

}  // namespace

Scan Ubx::scan(Bytes bytes) {
  if (const std::size_t noise = distance_to_sync(bytes)) return Scan::skip(noise);
  if (bytes.size() < ubx::header_size) return Scan::need_more();
  const std::size_t size = load_le<std::uint16_t>(bytes, 4) + ubx::overhead;
  if (size > max_frame) return Scan::skip(1);
  if (bytes.size() < size) return Scan::need_more();
  const auto sent = load_le<std::uint16_t>(bytes, size - ubx::checksum_size);
  return ubx::checksum(ubx::checked_part(bytes.first(size))) == sent ? Scan::frame(size)
                                                                     : Scan::bad_checksum();
}

std::optional<Ubx::Message> Ubx::decode(Bytes frame) {
  if (frame.size() < ubx::overhead) return std::nullopt;
  const Bytes payload = frame.subspan(ubx::header_size, frame.size() - ubx::overhead);
  switch (load_be<std::uint16_t>(frame, 2)) {
    case ubx::nav_pvt: return as_message(read_nav_pvt(payload));
    case ubx::nav_sat: {
      std::optional<Message> message{std::in_place, std::in_place_type<NavSat>};
      if (!read_nav_sat(payload, std::get<NavSat>(*message))) message.reset();
      return message;
    }
    case ubx::nav_eoe: return as_message(read_nav_eoe(payload));
    default: return std::nullopt;
  }
}

}  // namespace drydock::wire
