#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>

/// The contract of every byte protocol. A protocol is a struct `P` with
///  P::name                                   its name in rig files and on the command line
///  P::max_frame                              bytes of its longest frame
///  P::Message                                std::variant of its messages (SI units, optionals)
///  P::scan(bytes)   -> Scan                  classifies the first bytes
///  P::decode(frame) -> optional<Message>     empty: a valid frame with another kind of content
/// and, for messages that Drydock also sends, free functions `encode(message, out) -> size`.
namespace drydock::wire {

using Bytes = std::span<const std::uint8_t>;

/// Answer about the front of a byte stream. After a bad checksum the answer is "skip 1": the search
/// continues one byte after the sync, so the next good frame is never lost.
struct Scan {
  enum class Kind : std::uint8_t { frame, need_more, skip, bad_checksum };
  Kind kind = Kind::need_more;
  std::size_t size = 0;  ///< bytes of the frame, or bytes to skip; need_more: of need_more()

  static constexpr Scan frame(std::size_t n) { return {Kind::frame, n}; }
  /// `claimed`: bytes of the whole frame as its header says; 0: it does not say.
  static constexpr Scan need_more(std::size_t claimed = 0) { return {Kind::need_more, claimed}; }
  static constexpr Scan skip(std::size_t n) { return {Kind::skip, n}; }
  /// Skips one byte and counts a damaged frame.
  static constexpr Scan bad_checksum() { return {Kind::bad_checksum, 1}; }
  friend constexpr bool operator==(const Scan&, const Scan&) = default;
};

/// bytes_in = bytes_good + bytes_skipped + bytes that still wait in the buffer.
struct StreamCounters {
  std::uint64_t bytes_in = 0;
  std::uint64_t bytes_good = 0;     ///< inside valid frames
  std::uint64_t bytes_skipped = 0;  ///< noise, damaged frames
  std::uint64_t frames = 0;
  std::uint64_t bad_checksums = 0;  ///< and frames that were given up
  friend bool operator==(const StreamCounters&, const StreamCounters&) = default;
};

/// Cuts a stream into frames. `Capacity` must hold the longest frame. No allocation.
template <std::size_t Capacity>
class Framer {
 public:
  /// Feeds bytes. It calls `scan(Bytes) -> Scan` and, for each valid frame, `on_frame(Bytes frame,
  /// std::size_t after)`, where `after` is the number of bytes of this call's input behind the
  /// frame.
  template <class ScanFn, class OnFrame>
  void feed(Bytes bytes, ScanFn&& scan, OnFrame&& on_frame) {
    counters_.bytes_in += bytes.size();
    while (!bytes.empty()) {
      // A frame that is complete in the input needs no copy. Only an incomplete frame is kept.
      if (held_ == 0) {
        const std::size_t used = consume(bytes, bytes.size(), scan, on_frame);
        bytes = bytes.subspan(used);
        if (bytes.empty()) return;
      }
      const std::size_t take = std::min(bytes.size(), Capacity - held_);
      std::memcpy(buffer_.data() + held_, bytes.data(), take);
      held_ += take;
      bytes = bytes.subspan(take);
      const std::size_t used =
          consume(Bytes{buffer_.data(), held_}, held_ + bytes.size(), scan, on_frame);
      discard(used);
      if (held_ == Capacity) {  // a frame that does not fit is not a frame
        ++counters_.bytes_skipped;
        discard(1);
      }
    }
  }

  /// Bytes of the frame that the oldest held byte begins, as its header says; without a length in
  /// it, the most that a frame may have.
  std::size_t claimed() const { return claimed_ > 0 ? claimed_ : Capacity; }

  /// True if a whole frame lies behind the oldest held byte. Then that byte began no frame, unless
  /// frames of the protocol contain whole frames.
  template <class ScanFn>
  bool frame_behind(ScanFn&& scan) const {
    for (std::size_t at = 1; at < held_;) {
      const Scan s = scan(Bytes{buffer_.data() + at, held_ - at});
      if (s.kind == Scan::Kind::frame) return true;
      at += s.kind == Scan::Kind::skip ? s.size : 1;
    }
    return false;
  }

  /// Gives up the frame begun at the oldest held byte: it counts as damaged, and the search goes on
  /// one byte further. The framer has no clock; its owner decides when.
  template <class ScanFn, class OnFrame>
  void give_up(ScanFn&& scan, OnFrame&& on_frame) {
    if (held_ == 0) return;
    ++counters_.bad_checksums;
    ++counters_.bytes_skipped;
    discard(1);
    discard(consume(Bytes{buffer_.data(), held_}, held_, scan, on_frame));
  }

  /// The stream has ended. A frame that still waits for bytes is not a frame, so the search
  /// continues one byte after its sync.
  template <class ScanFn, class OnFrame>
  void finish(ScanFn&& scan, OnFrame&& on_frame) {
    while (held_ > 0) {
      const std::size_t used = consume(Bytes{buffer_.data(), held_}, held_, scan, on_frame);
      discard(used);
      if (used > 0 || held_ == 0) continue;
      ++counters_.bytes_skipped;
      discard(1);
    }
  }

  void reset() {
    counters_.bytes_skipped += held_;
    held_ = 0;
  }

  const StreamCounters& counters() const { return counters_; }
  std::size_t held() const { return held_; }

 private:
  template <class ScanFn, class OnFrame>
  std::size_t consume(Bytes bytes, std::size_t through_input_end, ScanFn& scan, OnFrame& on_frame) {
    std::size_t at = 0;
    while (at < bytes.size()) {
      const Scan s = scan(bytes.subspan(at));
      if (s.kind == Scan::Kind::need_more) {
        claimed_ = s.size;
        break;
      }
      if (s.kind == Scan::Kind::frame) {
        counters_.bytes_good += s.size;
        ++counters_.frames;
        on_frame(bytes.subspan(at, s.size), through_input_end - at - s.size);
      } else {
        counters_.bytes_skipped += s.size;
        counters_.bad_checksums += s.kind == Scan::Kind::bad_checksum;
      }
      at += s.size;
    }
    return at;
  }

  void discard(std::size_t n) {
    held_ -= n;
    std::memmove(buffer_.data(), buffer_.data() + n, held_);
  }

  std::array<std::uint8_t, Capacity> buffer_{};
  std::size_t held_ = 0;
  std::size_t claimed_ = 0;  ///< by the held frame's header; 0: it does not say
  StreamCounters counters_;
};

}  // namespace drydock::wire
