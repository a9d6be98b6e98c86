#include "drivers/wire/can/can_bits.hpp"

#include <bit>
#include <boost/crc.hpp>

namespace drydock::wire {
namespace {

__extension__ using Word = unsigned __int128;

/// The stuffed part of a classic frame, from start of frame to CRC: at most 118 bits. Bit 0 is the
/// last that is sent.
class StuffedBits {
 public:
  void put(std::uint64_t value, unsigned bits) {
    word_ = word_ << bits | value;
    count_ += bits;
  }

  /// CRC-15, polynomial 4599h, over all bits before it. It starts at 0, so the bits that fill the
  /// first byte have no effect.
  void put_crc() {
    boost::crc_optimal<15, 0x4599> crc;
    for (unsigned bytes = (count_ + 7) / 8; bytes-- > 0;)
      crc.process_byte(static_cast<unsigned char>(word_ >> 8 * bytes));
    put(crc.checksum(), 15);
  }

  unsigned count() const { return count_ + stuff_bits(); }

 private:
  static unsigned highest(Word word) {
    const auto upper = static_cast<std::uint64_t>(word >> 64);
    return upper != 0 ? 63 + static_cast<unsigned>(std::bit_width(upper))
                      : static_cast<unsigned>(std::bit_width(static_cast<std::uint64_t>(word))) - 1;
  }

  /// After five equal bits comes a bit of the other value. This bit counts towards the next five.
  unsigned stuff_bits() const {
    Word same = ~(word_ ^ word_ >> 1) & ((Word{1} << (count_ - 1)) - 1);  // as the bit before
    unsigned inserted = 0;
    while (const Word fifth = same & same >> 1 & same >> 2 & same >> 3) {
      ++inserted;
      const Word behind = (Word{1} << highest(fifth)) - 1;
      same = (same & behind) ^ (behind + 1) >> 1;
    }
    return inserted;
  }

  Word word_ = 0;
  unsigned count_ = 0;
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

/// After the first bit, the stuffed part has one stuff bit for every four bits. The CRC has 17 or
/// 21 bits, and in addition its stuff count and fixed stuff bits.
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
