#include "drivers/capture/formats/socketcan_packet.hpp"

#include <algorithm>

#include "drivers/capture/words.hpp"
#include "drivers/wire/bytes.hpp"

namespace drydock::capture {

std::optional<wire::CanFrame> parse_socketcan_packet(wire::Bytes packet, bool big_endian) {
  constexpr std::size_t head = 8, fd_packet = 72;
  constexpr std::uint32_t extended = 0x80000000, remote = 0x40000000, error = 0x20000000;
  constexpr std::uint8_t bit_rate_switch = 0x01, fd_format = 0x04, fd_flags = 0x07;
  if (packet.size() < head) return std::nullopt;
  const auto id = big_endian ? wire::load_be<std::uint32_t>(packet, 0)
                             : wire::load_le<std::uint32_t>(packet, 0);
  const std::uint8_t size = packet[4], flags = packet[5];
  wire::CanFrame frame;
  frame.error = (id & error) != 0;
  frame.remote = (id & remote) != 0;
  frame.extended = (id & extended) != 0 && !frame.error;
  frame.id = id & (frame.extended || frame.error ? 0x1FFFFFFFu : 0x7FFu);
  // Older kernels do not set the CAN FD flag; there the size of the packet tells it. They also do
  // not clear this byte of a classic frame, so other bits may be set in it.
  frame.fd = ((flags & fd_format) != 0 && (flags & ~fd_flags) == 0) || packet.size() == fd_packet;
  frame.bit_rate_switch = frame.fd && (flags & bit_rate_switch) != 0;
  if (!(frame.fd ? is_fd_size(size) : size <= 8)) return std::nullopt;
  frame.size = size;
  if (frame.remote) return frame;
  if (packet.size() < head + size) return std::nullopt;
  std::copy_n(packet.begin() + head, size, frame.data.begin());
  return frame;
}

}  // namespace drydock::capture
