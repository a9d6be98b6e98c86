#include "hil/emulate/heard_at.hpp"

#include <bit>
#include <cmath>

namespace drydock::emulate {
namespace {

/// The levels of a serial line: idle is high; then a start bit, data from the lowest bit, the
/// parity bit if there is one, stop bits.
class LineLevels {
 public:
  LineLevels(wire::Bytes bytes, wire::ByteFrame frame) : bytes_(bytes), frame_(frame) {}

  std::size_t bits() const { return bytes_.size() * frame_.bits(); }
  bool high(std::size_t bit) const {
    if (bit >= bits()) return true;
    const std::size_t place = bit % frame_.bits();
    const unsigned byte = bytes_[bit / frame_.bits()] & ((1u << frame_.data_bits) - 1);
    if (place == 0) return false;
    if (place <= frame_.data_bits) return (byte >> (place - 1) & 1) != 0;
    if (place == frame_.data_bits + 1) return first_after_data(byte);
    return true;
  }

 private:
  bool first_after_data(unsigned byte) const {
    const bool odd = std::popcount(byte) % 2 != 0;
    switch (frame_.parity) {
      case wire::Parity::even: return odd;
      case wire::Parity::odd: return !odd;
      case wire::Parity::space: return false;
      default: return true;  // mark, or a stop bit
    }
  }

  wire::Bytes bytes_;
  wire::ByteFrame frame_;
};

}  // namespace

std::vector<std::uint8_t> heard_at(wire::Bytes message, double sent_baud,
                                   wire::LineRate heard_rate) {
  const wire::ByteFrame& frame = heard_rate.frame;
  const LineLevels line(message, frame);
  const double bit = sent_baud / heard_rate.baud;  // of the receiver, in bits of the sender
  const double stop = frame.bits() - frame.stop_bits + 0.5;  // middle of the first stop bit
  const auto end = static_cast<double>(line.bits());
  const auto level = [&](double at) { return line.high(static_cast<std::size_t>(at)); };
  std::vector<std::uint8_t> heard;
  for (double at = 0; at < end;) {
    if (level(at)) {  // idle, or a high bit: go to the next edge
      at = std::floor(at) + 1;
      continue;
    }
    unsigned value = 0;
    for (unsigned i = 0; i < frame.data_bits; ++i)
      value |= (level(at + (1.5 + i) * bit) ? 1u : 0u) << i;
    const bool framed = level(at + stop * bit);
    heard.push_back(static_cast<std::uint8_t>(framed ? value : 0));
    at += stop * bit;  // search for the next start bit from the middle of the stop bit
    while (!framed && at < end && !level(at)) at = std::floor(at) + 1;
  }
  return heard;
}

}  // namespace drydock::emulate
