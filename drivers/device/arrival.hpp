#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "drivers/measurement/stamp.hpp"

namespace drydock::device {

using measurement::Stamp;

/// How a frame of a byte stream arrived.
struct Arrival {
  Stamp read_at;                    ///< end of the read that brought the frame's last byte
  std::size_t bytes = 0;            ///< of the frame
  std::size_t after = 0;            ///< bytes of that read behind the frame
  std::size_t skipped = 0;          ///< bytes between the frame before and this one
  Stamp not_before = Stamp::min();  ///< end of the frame before: what waited in a port, while the
                                    ///< host stood still, comes faster than the line carries it
};

/// When the bytes of a stream arrived: one mark for each read whose bytes are still needed. A frame
/// that waited is so known by the time of its own bytes. There is room for a fixed number of marks.
/// When it is full, the two reads with the shortest pause between them become one.
class ArrivalMarks {
 public:
  static constexpr std::size_t most = 64;

  /// A read whose last byte is the stream's byte number `through`, counted from 1. Its first byte
  /// began at `begun_at`, its last ended at `ended_at`.
  void add(std::uint64_t through, Stamp begun_at, Stamp ended_at) {
    if (size_ == most) join_closest();
    marks_[size_++] = {through, begun_at, ended_at};
  }

  /// The first byte that is still needed is number `first`, counted from 1.
  void forget_before(std::uint64_t first) {
    std::size_t used = 0;
    while (used < size_ && marks_[used].through < first) ++used;
    remove(0, used);
  }

  /// The read that brought byte number `byte`: its end, and the bytes in it behind that byte. The
  /// byte must be one that was added and not forgotten.
  Arrival of(std::uint64_t byte) const {
    std::size_t i = 0;
    while (i + 1 < size_ && marks_[i].through < byte) ++i;
    return {marks_[i].ended_at, 0, static_cast<std::size_t>(marks_[i].through - byte)};
  }

 private:
  struct Mark {
    std::uint64_t through = 0;
    Stamp begun_at{}, ended_at{};
  };

  void remove(std::size_t at, std::size_t n) {
    std::copy(marks_.data() + at + n, marks_.data() + size_, marks_.data() + at);
    size_ -= n;
  }

  void join_closest() {
    std::size_t closest = 1;
    for (std::size_t i = 2; i < size_; ++i)
      if (pause_before(i) < pause_before(closest)) closest = i;
    marks_[closest].begun_at = marks_[closest - 1].begun_at;
    remove(closest - 1, 1);
  }

  Stamp::duration pause_before(std::size_t i) const {
    return marks_[i].begun_at - marks_[i - 1].ended_at;
  }

  std::array<Mark, most> marks_{};
  std::size_t size_ = 0;
};

}  // namespace drydock::device
