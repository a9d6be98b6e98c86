#include "hil/emulate/can_pacer.hpp"

#include <algorithm>
#include <array>

namespace drydock::emulate {
namespace {

/// CRC-15-CAN (polynomial 4599h, initial value 0) of one more byte; `crc` is left-aligned in 16
/// bits.
constexpr auto crc_table = [] {
  std::array<std::uint16_t, 256> table{};
  for (unsigned byte = 0; byte < table.size(); ++byte) {
    unsigned crc = byte << 8;
    for (int bit = 0; bit < 8; ++bit) crc = (crc << 1) ^ (crc & 0x8000 ? 0x4599u << 1 : 0);
    table[byte] = static_cast<std::uint16_t>(crc);
  }
  return table;
}();

/// After five equal bits the sender inserts a bit of the other value, which counts towards the next
/// five. State: 4 * last bit + length of its run - 1. Entry: 8 * inserted bits + state.
constexpr auto stuff_table = [] {
  std::array<std::array<std::uint8_t, 256>, 8> table{};
  for (unsigned state = 0; state < table.size(); ++state) {
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
      table[state][byte] = static_cast<std::uint8_t>(8 * inserted + 4 * last + run - 1);
    }
  }
  return table;
}();

/// Takes the bytes of a frame in the order of sending.
class Stuffing {
 public:
  void put(unsigned byte) {
    const unsigned entry = stuff_table[state_][byte];
    inserted_ += entry / 8;
    state_ = entry % 8;
  }
  unsigned inserted() const { return inserted_; }

 private:
  unsigned state_ = 0, inserted_ = 0;
};

/// The bits before the data. Leading bits that fill the first byte are 0, which does not change the
/// CRC. `fill` sets some of them for the stuffing, which must see alternating bits there.
struct Header {
  std::uint64_t bits = 0;
  unsigned size = 0, bytes = 0;
  std::uint64_t fill = 0;
};

Header header_of(const wire::CanFrame& frame) {
  const std::uint64_t remote = frame.remote, length = frame.size & 0xF;
  if (!frame.extended)  // start of frame, identifier, remote, extension, a reserved bit, length
    return {std::uint64_t{frame.id} << 7 | remote << 6 | length, 19, 3,
            std::uint64_t{0b10101} << 19};
  // start of frame, identifier, substitute remote and extension, identifier, remote, two reserved
  return {std::uint64_t{frame.id >> 18} << 27 | std::uint64_t{0b11} << 25 |
              std::uint64_t{frame.id & 0x3FFFF} << 7 | remote << 6 | length,
          39, 5, std::uint64_t{1} << 39};
}

constexpr unsigned crc_bits = 15;
// CRC delimiter, acknowledge slot and delimiter, end of frame, intermission.
constexpr unsigned intermission_bits = 3;
constexpr unsigned unstuffed_bits = 1 + 2 + 7 + intermission_bits;

}  // namespace

unsigned bits_on_wire(const wire::CanFrame& frame) {
  const Header header = header_of(frame);
  unsigned crc = 0;
  Stuffing stuffing;
  const auto put = [&](std::uint8_t byte, unsigned as_stuffed) {
    crc = (crc << 8 ^ crc_table[(crc >> 8 ^ byte) & 0xFF]) & 0xFFFF;
    stuffing.put(as_stuffed);
  };
  for (unsigned i = header.bytes; i-- > 0;) {
    put(static_cast<std::uint8_t>(header.bits >> 8 * i),
        static_cast<unsigned>((header.bits | header.fill) >> 8 * i) & 0xFF);
  }
  const auto data = frame.remote ? std::span<const std::uint8_t>{} : frame.payload();
  for (const std::uint8_t byte : data) put(byte, byte);
  stuffing.put(crc >> 8);
  stuffing.put((crc & 0xFE) | (~crc >> 1 & 1));  // the sixteenth bit ends a run, so no bit is
                                                 // inserted
  return header.size + 8 * static_cast<unsigned>(data.size()) + crc_bits + stuffing.inserted() +
         unstuffed_bits;
}

// Rounds up, so that no frame ends early.
std::chrono::nanoseconds CanPacer::line_time(unsigned bits) const {
  return std::chrono::nanoseconds{(std::uint64_t{bits} * 1'000'000'000 + bit_rate_ - 1) /
                                  bit_rate_};
}

void CanPacer::begin_first() {
  const unsigned bits = bits_on_wire(waiting_.front().frame);
  first_begins_ = std::max(free_at_, waiting_.front().queued_at);
  first_ends_ = first_begins_ + line_time(bits - intermission_bits);
  free_at_ = first_begins_ + line_time(bits);
}

void CanPacer::queue(const wire::CanFrame& frame, int sender, Stamp now,
                     std::optional<Stamp> sampled_at) {
  if (waiting_.size() > bound) {
    waiting_.erase(waiting_.begin() + 1);
    ++frames_lost_;
  }
  waiting_.push_back({frame, sender, now, sampled_at});
  if (waiting_.size() == 1) begin_first();
}

std::optional<Stamp> CanPacer::deadline() const {
  if (waiting_.empty()) return std::nullopt;
  return first_ends_;
}

std::optional<CanPacer::Sent> CanPacer::take(Stamp now) {
  if (waiting_.empty() || first_ends_ > now) return std::nullopt;
  const Waiting& first = waiting_.front();
  const Sent sent{first.frame,
                  first_ends_,
                  first.sender,
                  {first.sampled_at, first.queued_at, first_begins_, first_ends_}};
  waiting_.erase(waiting_.begin());
  if (!waiting_.empty()) begin_first();
  return sent;
}

}  // namespace drydock::emulate
