#include "drivers/capture/formats/message_frames.hpp"

#include <algorithm>

namespace drydock::capture {

Record MessageFrames::first(const N2kMessage& message, bool is_fast) {
  message_ = message;
  is_fast_ = is_fast;
  given_ = 0;
  sequence_ = (sequence_ + 1) % 8;
  return next();
}

std::optional<Record> MessageFrames::more() {
  if (!is_fast_ || given_ >= wire::fast_packet_frames(message_.size)) return std::nullopt;
  return next();
}

Record MessageFrames::next() {
  Record record{message_.time, "can0", {}};
  const wire::Bytes data{message_.data.data(), message_.size};
  if (is_fast_) {
    record.frame = wire::encode_fast_packet(message_.id, sequence_, data, given_);
  } else {
    record.frame.id = wire::j1939::make_identifier(message_.id);
    record.frame.extended = true;
    record.frame.size = static_cast<std::uint8_t>(data.size());
    std::copy(data.begin(), data.end(), record.frame.data.begin());
  }
  ++given_;
  return record;
}

}  // namespace drydock::capture
