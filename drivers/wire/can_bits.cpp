#include "drivers/wire/can_bits.hpp"

namespace drydock::wire {
namespace {

/// The part of a classic frame that is stuffed, start of frame to CRC, bit by bit.
class StuffedBits {
 public:
  void put(std::uint32_t value, int bits) {
    for (int i = bits - 1; i >= 0; --i) put_bit(value >> i & 1);
  }
  /// CRC-15, polynomial 4599h, over all bits before it.
  void put_crc() { put(crc_, 15); }
  unsigned count() const { return count_; }

 private:
  void put_bit(bool bit) {
    const bool feeds_back = bit != ((crc_ >> 14 & 1) != 0);
    crc_ = (crc_ << 1 & 0x7FFF) ^ (feeds_back ? 0x4599u : 0u);
    append(bit);
    constexpr unsigned longest_run = 5;
    if (run_ == longest_run) append(!bit);
  }
  void append(bool bit) {
    run_ = count_ > 0 && bit == last_ ? run_ + 1 : 1;
    last_ = bit;
    ++count_;
  }

  unsigned count_ = 0, run_ = 0;
  bool last_ = false;
  std::uint32_t crc_ = 0;
};

constexpr unsigned behind_the_crc = 1 + 2 + 7 + 3;  // delimiter, acknowledgement, end, intermission

unsigned classic_bits(const CanFrame& frame) {
  StuffedBits bits;
  bits.put(0, 1);  // start of frame
  if (frame.extended) {
    bits.put(frame.id >> 18 & 0x7FF, 11);
    bits.put(3, 2);  // SRR, IDE
    bits.put(frame.id & 0x3FFFF, 18);
    bits.put(frame.remote, 1);
    bits.put(0, 2);  // r1, r0
  } else {
    bits.put(frame.id & 0x7FF, 11);
    bits.put(frame.remote, 1);
    bits.put(0, 2);  // IDE, r0
  }
  bits.put(frame.size, 4);
  if (!frame.remote)
    for (const std::uint8_t byte : frame.payload()) bits.put(byte, 8);
  bits.put_crc();
  return bits.count() + behind_the_crc;
}

/// One stuff bit for every four behind the first in the stuffed part; the CRC of 17 or 21 bits has
/// its stuff count and fixed stuff bits.
unsigned longest_fd_bits(const CanFrame& frame) {
  const unsigned head = frame.extended ? 41 : 22;
  const unsigned stuffed = head + 8u * frame.size;
  const unsigned crc = frame.size > 16 ? 4 + 21 + 7 : 4 + 17 + 6;
  return stuffed + (stuffed - 1) / 4 + crc + behind_the_crc;
}

}  // namespace

unsigned wire_bits(const CanFrame& frame) {
  if (frame.error) return 0;
  return frame.fd ? longest_fd_bits(frame) : classic_bits(frame);
}

}  // namespace drydock::wire
