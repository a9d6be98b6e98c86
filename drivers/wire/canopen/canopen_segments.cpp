#include "drivers/wire/canopen/canopen_segments.hpp"

#include <algorithm>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/canopen/canopen.hpp"

namespace drydock::wire::canopen {

namespace {

// Byte 0: the specifier of the service, and its bits.
constexpr unsigned download_segment = 0, initiate_download = 1, upload_segment = 3, given_up = 4,
                   block_upload = 5;
constexpr unsigned answered_segment = 1, answered_upload = 2;
constexpr unsigned segment_toggle = 0x10, last_bit = 0x01, expedited_bit = 0x02, size_bit = 0x01,
                   block_command = 0x03;

CanFrame sdo_answer(std::uint8_t node, unsigned command) {
  CanFrame frame;
  frame.id = sdo_response_base + node;
  frame.size = 8;
  frame.data[0] = static_cast<std::uint8_t>(command);
  return frame;
}

SdoSegment segment_of(std::uint8_t node, const CanFrame& frame) {
  SdoSegment segment{
      node, (frame.data[0] & segment_toggle) != 0, (frame.data[0] & last_bit) != 0, {}, 0};
  const unsigned unused = frame.data[0] >> 1 & 7;
  segment.size = static_cast<std::uint8_t>(SdoSegment::most_bytes - unused);
  std::copy_n(frame.data.begin() + 1, segment.size, segment.data.begin());
  return segment;
}

}  // namespace

std::optional<SdoLongRequest> decode_sdo_long_request(const CanFrame& frame) {
  const auto node = node_above(frame, sdo_request_base);
  if (!node || frame.size != 8) return std::nullopt;
  const unsigned command = frame.data[0];
  const ObjectEntry entry{load_le<std::uint16_t>(frame.data, 1), frame.data[3]};
  switch (command >> 5) {
    case upload_segment: return SdoNextSegment{*node, (command & segment_toggle) != 0};
    case download_segment: return segment_of(*node, frame);
    case given_up: return SdoGivenUp{*node};
    case initiate_download: {
      if ((command & expedited_bit) != 0) return std::nullopt;
      SdoLongWrite write{*node, entry, {}};
      if ((command & size_bit) != 0) write.size = load_le<std::uint32_t>(frame.data, 4);
      return write;
    }
    case block_upload:
      if ((command & block_command) != 0) return std::nullopt;
      return SdoBlockRead{*node, entry, frame.data[5]};
    default: return std::nullopt;
  }
}

CanFrame encode(const SdoLongValue& m) {
  CanFrame frame = sdo_answer(m.node, answered_upload << 5 | size_bit);
  store_le<std::uint16_t>(frame.data, 1, m.entry.index);
  frame.data[3] = m.entry.subindex;
  store_le<std::uint32_t>(frame.data, 4, m.size);
  return frame;
}

CanFrame encode(const SdoSegment& m) {
  const unsigned unused = SdoSegment::most_bytes - m.size;
  CanFrame frame =
      sdo_answer(m.node, (m.toggle ? segment_toggle : 0) | unused << 1 | (m.last ? last_bit : 0));
  std::copy_n(m.data.begin(), m.size, frame.data.begin() + 1);
  return frame;
}

CanFrame encode(const SdoSegmentTaken& m) {
  return sdo_answer(m.node, answered_segment << 5 | (m.toggle ? segment_toggle : 0));
}

}  // namespace drydock::wire::canopen
