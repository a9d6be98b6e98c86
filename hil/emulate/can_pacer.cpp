#include "hil/emulate/can_pacer.hpp"

#include <algorithm>

namespace drydock::emulate {
namespace {

// Counts the bits that are subject to stuffing: after five equal bits the sender inserts one of the
// other value, which itself counts towards the next five.
class StuffedBits {
 public:
  void put(std::uint32_t value, unsigned width) {
    while (width > 0) put_bit((value >> --width) & 1);
  }
  void put_crc() { put(crc_, 15); }
  unsigned count() const { return count_; }

 private:
  void put_bit(std::uint32_t bit) {
    const bool divide = (bit ^ (crc_ >> 14)) & 1;
    crc_ = (crc_ << 1) & 0x7FFF;
    if (divide) crc_ ^= 0x4599;
    ++count_;
    run_ = bit == last_ ? run_ + 1 : 1;
    last_ = bit;
    if (run_ == 5) {
      ++count_;
      last_ = 1 - bit;
      run_ = 1;
    }
  }

  std::uint32_t crc_ = 0;
  std::uint32_t last_ = 2;  // neither 0 nor 1: the first bit begins a run
  unsigned run_ = 0, count_ = 0;
};

// CRC delimiter, acknowledge slot and delimiter, end of frame, intermission.
constexpr unsigned unstuffed_bits = 1 + 2 + 7 + 3;

}  // namespace

unsigned bits_on_wire(const wire::CanFrame& frame) {
  StuffedBits bits;
  const std::uint32_t remote = frame.remote;
  bits.put(0, 1);  // start of frame
  if (frame.extended) {
    bits.put(frame.id >> 18, 11);
    bits.put(0b11, 2);  // substitute remote request, identifier extension
    bits.put(frame.id & 0x3FFFF, 18);
    bits.put(remote << 2, 3);  // and two reserved bits
  } else {
    bits.put(frame.id, 11);
    bits.put(remote << 2, 3);  // identifier extension, a reserved bit
  }
  bits.put(frame.size, 4);
  if (!frame.remote) {
    for (const std::uint8_t byte : frame.payload()) bits.put(byte, 8);
  }
  bits.put_crc();
  return bits.count() + unstuffed_bits;
}

Stamp CanPacer::end_of(const Waiting& frame, Stamp earliest) const {
  const std::uint64_t bits = bits_on_wire(frame.frame);
  const std::uint64_t ns = (bits * 1'000'000'000 + bit_rate_ - 1) / bit_rate_;
  return std::max(earliest, frame.queued_at) + std::chrono::nanoseconds{ns};
}

void CanPacer::queue(const wire::CanFrame& frame, int sender, Stamp now) {
  if (waiting_.size() > bound) {
    waiting_.erase(waiting_.begin() + 1);
    ++frames_lost_;
  }
  waiting_.push_back({frame, sender, now});
  if (waiting_.size() == 1) first_ends_ = end_of(waiting_.front(), first_ends_);
}

std::optional<Stamp> CanPacer::deadline() const {
  if (waiting_.empty()) return std::nullopt;
  return first_ends_;
}

std::optional<CanPacer::Sent> CanPacer::take(Stamp now) {
  if (waiting_.empty() || first_ends_ > now) return std::nullopt;
  const Sent sent{waiting_.front().frame, first_ends_, waiting_.front().sender};
  waiting_.erase(waiting_.begin());
  if (!waiting_.empty()) first_ends_ = end_of(waiting_.front(), first_ends_);
  return sent;
}

}  // namespace drydock::emulate
