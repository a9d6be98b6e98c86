#include "drivers/wire/can/can_bits.hpp"

#include <algorithm>
#include <array>
#include <span>

namespace drydock::wire {
namespace {

/// CRC-15-CAN (polynomial 4599h, initial value 0) of one more byte; `crc` is left-aligned in 16
/// bits.
constexpr auto can_crc_table = [] {
  std::array<std::uint16_t, 256> table{};
  for (unsigned byte = 0; byte < table.size(); ++byte) {
    unsigned crc = byte << 8;
    for (int bit = 0; bit < 8; ++bit) crc = (crc << 1) ^ (crc & 0x8000 ? 0x4599u << 1 : 0);
    table[byte] = static_cast<std::uint16_t>(crc);
  }
  return table;
}();

/// After five equal bits the sender inserts a bit of the other value, which counts towards the next
/// five. State: 4 * last bit + length of its run - 1. Index: 256 * state + byte. Entry: 4096 *
/// inserted bits + 256 * next state.
constexpr auto stuff_table = [] {
  std::array<std::uint16_t, 8 * 256> table{};
  for (unsigned state = 0; state < 8; ++state) {
    for (unsigned byte = 0; byte < 256; ++byte) {
      unsigned last = state / 4, run = state % 4 + 1, inserted = 0;
      for (int place = 7; place >= 0; --place) {
        const unsigned bit = (byte >> place) & 1;
        run = bit == last ? run + 1 : 1;
        last = bit;
        if (run < 5) continue;
        ++inserted;
        last = 1 - bit;
        run = 1;
      }
      table[256 * state + byte] =
          static_cast<std::uint16_t>(4096 * inserted + 256 * (4 * last + run - 1));
    }
  }
  return table;
}();

/// Takes the bytes of a frame in the order of sending.
class Stuffing {
 public:
  void put(std::uint8_t byte) {
    const unsigned entry = stuff_table[state_ | byte];
    inserted_ += entry / 4096;
    state_ = entry & 0x700;
  }
  unsigned inserted() const { return inserted_; }

 private:
  unsigned state_ = 0, inserted_ = 0;  ///< 256 times the state
};

class Crc {
 public:
  void put(std::uint8_t byte) {
    crc_ = static_cast<std::uint16_t>(crc_ << 8 ^ can_crc_table[crc_ >> 8 ^ byte]);
  }
  std::uint16_t value() const { return crc_; }  ///< left-aligned

 private:
  std::uint16_t crc_ = 0;
};

/// The bits before the data. Leading bits that fill the first byte are 0, which does not change the
/// CRC. `fill` sets some of them for the stuffing, which must see alternating bits there.
struct HeadBits {
  std::uint64_t bits = 0;
  unsigned size = 0, bytes = 0;
  std::uint64_t fill = 0;
};

HeadBits head_bits_of(const CanFrame& frame) {
  const std::uint64_t remote = frame.remote, length = frame.size & 0xF;
  if (!frame.extended)  // start of frame, identifier, remote, extension, a reserved bit, length
    return {std::uint64_t{frame.id & 0x7FF} << 7 | remote << 6 | length, 19, 3,
            std::uint64_t{0b10101} << 19};
  // start of frame, identifier, substitute remote and extension, identifier, remote, two reserved
  return {std::uint64_t{frame.id >> 18 & 0x7FF} << 27 | std::uint64_t{0b11} << 25 |
              std::uint64_t{frame.id & 0x3FFFF} << 7 | remote << 6 | length,
          39, 5, std::uint64_t{1} << 39};
}

constexpr unsigned crc_bits = 15;
constexpr unsigned behind_the_crc = 1 + 2 + 7 + 3;  // delimiter, acknowledgement, end, intermission

/// After the first bit, the stuffed part has one stuff bit for every four bits. The CRC has 17 or
/// 21 bits, and in addition its stuff count and fixed stuff bits.
unsigned longest_fd_bits(const CanFrame& frame) {
  const unsigned head = frame.extended ? 41 : 22;
  const unsigned stuffed = head + 8u * frame.size;
  const unsigned crc = frame.size > 16 ? 4 + 21 + 7 : 4 + 17 + 6;
  return stuffed + (stuffed - 1) / 4 + crc + behind_the_crc;
}

/// From the start of frame to the bit that switches the rate.
unsigned longest_arbitration_bits(const CanFrame& frame) {
  const unsigned bits = frame.extended ? 36 : 17;
  return bits + (bits - 1) / 4;
}

}  // namespace

unsigned data_phase_bits(const CanFrame& frame) {
  if (!frame.fd || !frame.bit_rate_switch) return 0;
  return longest_fd_bits(frame) - longest_arbitration_bits(frame) - behind_the_crc;
}

namespace {

/// The bits of a frame of the first two kinds of CAN, and the frame.
struct Counted {
  CanFrame frame;
  unsigned bits = 0;  ///< 0: none
};

bool are_same_bits(const CanFrame& a, const CanFrame& b) {
  return a.id == b.id && a.size == b.size && a.extended == b.extended && a.remote == b.remote &&
         std::ranges::equal(a.payload(), b.payload());
}

unsigned count_classic_bits(const CanFrame& frame) {
  const HeadBits head = head_bits_of(frame);
  Crc crc;
  Stuffing stuffing;
  for (unsigned shift = 8 * head.bytes; shift > 0;) {
    shift -= 8;
    crc.put(static_cast<std::uint8_t>(head.bits >> shift));
    stuffing.put(static_cast<std::uint8_t>((head.bits | head.fill) >> shift));
  }
  const auto data = frame.remote ? std::span<const std::uint8_t>{} : frame.payload();
  for (const std::uint8_t byte : data) {
    crc.put(byte);
    stuffing.put(byte);
  }
  const unsigned check = crc.value();
  stuffing.put(static_cast<std::uint8_t>(check >> 8));
  // The sixteenth bit ends a run, so no bit is inserted.
  stuffing.put(static_cast<std::uint8_t>((check & 0xFE) | (~check >> 1 & 1)));
  return head.size + 8 * static_cast<unsigned>(data.size()) + crc_bits + stuffing.inserted() +
         behind_the_crc;
}

}  // namespace

// Pacer, drivers and monitors ask for the same frame one after the other, the pacer for its
// successor in between.
unsigned classic_bits(const CanFrame& frame) {
  constexpr std::size_t kept = 4;
  thread_local std::array<Counted, kept> latest{};
  thread_local std::size_t next = 0;
  for (const Counted& counted : latest)
    if (counted.bits > 0 && are_same_bits(counted.frame, frame)) return counted.bits;
  Counted& oldest = latest[next++ % kept];
  oldest = {frame, count_classic_bits(frame)};
  return oldest.bits;
}

unsigned wire_bits(const CanFrame& frame) {
  if (frame.error) return 0;
  return frame.fd ? longest_fd_bits(frame) : classic_bits(frame);
}

}  // namespace drydock::wire
