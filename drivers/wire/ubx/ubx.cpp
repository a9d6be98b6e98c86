#include "drivers/wire/ubx/ubx.hpp"

#include <cstring>

#include "drivers/wire/ubx/ubx_decode.hpp"

namespace drydock::wire {
namespace {

/// Number of bytes before the next B5 that is a sync or may become one.
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

constexpr std::size_t longest_frame(std::uint16_t class_and_id) {
  return class_and_id == RxmRawx::class_and_id ? Ubx::max_frame
                                               : Ubx::longest_payload + ubx::overhead;
}

}  // namespace

Scan Ubx::scan(Bytes bytes) {
  if (const std::size_t noise = distance_to_sync(bytes)) return Scan::skip(noise);
  if (bytes.size() < ubx::header_size) return Scan::need_more();
  const std::size_t size = load_le<std::uint16_t>(bytes, 4) + ubx::overhead;
  if (size > longest_frame(load_be<std::uint16_t>(bytes, 2))) return Scan::skip(1);
  if (bytes.size() < size) return Scan::need_more(size);
  const auto sent = load_le<std::uint16_t>(bytes, size - ubx::checksum_size);
  return fletcher8(ubx::checked_part(bytes.first(size))) == sent ? Scan::frame(size)
                                                                 : Scan::bad_checksum();
}

std::optional<Ubx::Message> Ubx::decode(Bytes frame) { return decode_ubx<Message>(frame); }

}  // namespace drydock::wire
