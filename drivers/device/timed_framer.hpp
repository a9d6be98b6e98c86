#pragma once

#include <algorithm>
#include <chrono>
#include <optional>

#include "drivers/device/arrival.hpp"
#include "drivers/wire/codec.hpp"
#include "drivers/wire/line_rate.hpp"

namespace drydock::device {

/// The longest that good frames wait behind a damaged length, on a link of any rate or without
/// one (TCP, UDP). Most frames need less at 115200 baud, and a device is stale only after seconds.
/// A frame that is sent more slowly is not lost: see TimedFramer.
constexpr std::chrono::milliseconds longest_wait{500};

/// The framer of every stream that is heard in real time. It adds arrival times to wire::Framer.
///
/// A damaged length claims bytes that never come, and good frames wait behind it. So when the frame
/// at the oldest byte has waited for as long as its claimed length takes at the line's rate, or for
/// `longest_wait`, the framer looks behind it. If a whole frame is there, the first one is given
/// up. Otherwise it may still come (a slow line, a host that stalled), and the framer looks again
/// with the next bytes. A frame that comes out late keeps the time at which its own bytes arrived.
///
/// `scan(Bytes) -> Scan` and `on_frame(Bytes frame, const Arrival&)` are the same in all calls.
template <std::size_t Capacity>
class TimedFramer {
 public:
  explicit TimedFramer(wire::LineRate rate = {}) : rate_(rate) {}

  template <class ScanFn, class OnFrame>
  void feed(wire::Bytes bytes, Stamp received_at, ScanFn&& scan, OnFrame&& on_frame) {
    fed_ += bytes.size();
    marks_.add(fed_, received_at - rate_.time_of(bytes.size()), received_at);
    framer_.feed(bytes, scan, teller(on_frame));
    tick(received_at, scan, on_frame);
  }
  template <class ScanFn, class OnFrame>
  void tick(Stamp now, ScanFn&& scan, OnFrame&& on_frame) {
    look_behind([&] { return now >= overdue_at(); }, scan, on_frame);
    look_at_.reset();
    if (framer_.held() > 0 && now < overdue_at()) look_at_ = overdue_at();
  }
  /// When tick() is wanted; empty: not before the next bytes.
  std::optional<Stamp> deadline() const { return look_at_; }

  /// Gives up the oldest frame, and those that then are the oldest, while `overdue()` is true and a
  /// whole frame lies behind.
  template <class Overdue, class ScanFn, class OnFrame>
  void look_behind(Overdue&& overdue, ScanFn&& scan, OnFrame&& on_frame) {
    while (framer_.held() > 0 && overdue() && framer_.frame_behind(scan))
      framer_.give_up(scan, teller(on_frame));
    forget_used();
  }
  /// The stream has ended: see wire::Framer.
  template <class ScanFn, class OnFrame>
  void finish(ScanFn&& scan, OnFrame&& on_frame) {
    framer_.finish(scan, teller(on_frame));
    forget_used();
  }
  void reset() {
    framer_.reset();
    forget_used();
    last_end_ = Stamp::min();
  }

  void set_baud(unsigned baud) { rate_.baud = baud; }
  const wire::StreamCounters& counters() const { return framer_.counters(); }
  std::size_t held() const { return framer_.held(); }

 private:
  template <class OnFrame>
  auto teller(OnFrame& on_frame) {
    return [this, &on_frame](wire::Bytes frame, std::size_t after) {
      Arrival arrival = marks_.of(fed_ - after);
      arrival.bytes = frame.size();
      arrival.skipped = framer_.counters().bytes_skipped - skipped_;
      skipped_ = framer_.counters().bytes_skipped;
      if (last_end_ > arrival.read_at) last_end_ = Stamp::min();  // the host's clock was set back
      arrival.not_before = last_end_;
      last_end_ = std::max(arrival.read_at - rate_.time_of(arrival.after), last_end_);
      on_frame(frame, arrival);
    };
  }

  Stamp overdue_at() const {
    const Arrival oldest = marks_.of(fed_ - framer_.held() + 1);
    const Stamp begun_at = oldest.read_at - rate_.time_of(oldest.after + 1);
    const auto claimed = rate_.time_of(framer_.claimed());
    return begun_at + (claimed.count() > 0
                           ? std::min<std::chrono::nanoseconds>(claimed, longest_wait)
                           : longest_wait);
  }

  void forget_used() {
    marks_.forget_before(fed_ - framer_.held() + 1);
    if (framer_.held() == 0) look_at_.reset();
  }

  wire::LineRate rate_;
  wire::Framer<Capacity> framer_;
  std::uint64_t fed_ = 0;      ///< bytes since it was made
  std::uint64_t skipped_ = 0;  ///< of its bytes, in front of the frame that came out last
  ArrivalMarks marks_;
  Stamp last_end_ = Stamp::min();  ///< of the frame that came out last
  std::optional<Stamp> look_at_;
};

}  // namespace drydock::device
