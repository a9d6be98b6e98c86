#pragma once

#include <algorithm>
#include <chrono>

#include "drivers/device/arrival.hpp"
#include "drivers/device/driver.hpp"
#include "drivers/device/timing.hpp"

namespace drydock::device {

/// The longest that good frames wait behind a damaged length, on a link of any rate or without
/// one (TCP, UDP). Most frames need less at 115200 baud, and a device is stale only after seconds.
/// A frame that is sent more slowly is not lost: see StreamDriver.
constexpr std::chrono::milliseconds longest_wait{500};

/// The common parts of drivers on byte links: the framer, the arrival times and the timing.
///
/// A damaged length claims bytes that never come, and good frames wait behind it. So when the frame
/// at the oldest byte has waited for as long as its claimed length takes at the line's rate, or for
/// `longest_wait`, the driver looks behind it. If a whole frame is there, the first one is given
/// up. Otherwise it may still come (a slow line, a host that stalled), and the driver looks again
/// with the next bytes. A frame that comes out late keeps the time at which its own bytes arrived.
template <std::size_t Capacity, class Scanner = wire::Scan (*)(wire::Bytes)>
class StreamDriver : public ByteDriver {
 public:
  void receive(wire::Bytes bytes, Stamp received_at, Output& out) override {
    fed_ += bytes.size();
    marks_.add(fed_, received_at - timing_.line_time(bytes.size()), received_at);
    framer_.feed(bytes, scan_, teller(out));
    look_behind_overdue(received_at, out);
  }
  void tick(Stamp now, Output& out) override { look_behind_overdue(now, out); }
  std::optional<Stamp> deadline() const override { return look_at_; }
  void finish(Output& out) override {
    framer_.finish(scan_, teller(out));
    forget_used();
  }
  void restart(Stamp, Output&) override {
    framer_.reset();
    forget_used();
  }
  const wire::StreamCounters& counters() const final { return framer_.counters(); }
  std::size_t held_bytes() const final { return framer_.held(); }
  void set_provenance(measurement::Provenance provenance) final {
    timing_.set_provenance(provenance);
  }
  void set_baud(unsigned baud) final { timing_.set_baud(baud); }

 protected:
  StreamDriver(const DriverOptions& options, Scanner scan) : timing_(options), scan_(scan) {}

  /// A whole frame of the protocol.
  virtual void on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) = 0;

  /// Gives up the oldest frame, and those that then are the oldest, while `overdue()` is true and a
  /// whole frame lies behind.
  template <class Overdue>
  void look_behind(Output& out, Overdue&& overdue) {
    while (framer_.held() > 0 && overdue() && framer_.frame_behind(scan_))
      framer_.give_up(scan_, teller(out));
    forget_used();
  }

  Timing timing_;
  wire::Framer<Capacity> framer_;

 private:
  auto teller(Output& out) {
    return [this, &out](wire::Bytes frame, std::size_t after) {
      Arrival arrival = marks_.of(fed_ - after);
      arrival.bytes = frame.size();
      on_frame(frame, arrival, out);
    };
  }

  void look_behind_overdue(Stamp now, Output& out) {
    look_behind(out, [&] { return now >= overdue_at(); });
    look_at_.reset();
    if (framer_.held() > 0 && now < overdue_at()) look_at_ = overdue_at();
  }

  Stamp overdue_at() const {
    const Arrival oldest = marks_.of(fed_ - framer_.held() + 1);
    const Stamp begun_at = oldest.read_at - timing_.line_time(oldest.after + 1);
    const auto claimed = timing_.line_time(framer_.claimed());
    return begun_at + (claimed.count() > 0
                           ? std::min<std::chrono::nanoseconds>(claimed, longest_wait)
                           : longest_wait);
  }

  void forget_used() {
    marks_.forget_before(fed_ - framer_.held() + 1);
    if (framer_.held() == 0) look_at_.reset();
  }

  Scanner scan_;
  std::uint64_t fed_ = 0;  ///< bytes since the driver was made
  ArrivalMarks marks_;
  std::optional<Stamp> look_at_;
};

}  // namespace drydock::device
