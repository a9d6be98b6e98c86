#pragma once

#include "drivers/device/driver.hpp"
#include "drivers/device/timed_framer.hpp"
#include "drivers/device/timing.hpp"

namespace drydock::device {

/// The common parts of drivers on byte links: the framer with its arrival times, and the timing.
template <std::size_t Capacity, class Scanner = wire::Scan (*)(wire::Bytes)>
class StreamDriver : public ByteDriver {
 public:
  void receive(wire::Bytes bytes, Stamp received_at, Output& out) override {
    framer_.feed(bytes, received_at, scan_, teller(out));
  }
  void tick(Stamp now, Output& out) override { framer_.tick(now, scan_, teller(out)); }
  std::optional<Stamp> deadline() const override { return framer_.deadline(); }
  void finish(Output& out) override { framer_.finish(scan_, teller(out)); }
  void restart(Stamp, Output&) override { framer_.reset(); }
  const wire::StreamCounters& counters() const final { return framer_.counters(); }
  std::size_t held_bytes() const final { return framer_.held(); }
  void set_provenance(measurement::Provenance provenance) final {
    timing_.set_provenance(provenance);
  }
  void set_baud(unsigned baud) final {
    timing_.set_baud(baud);
    framer_.set_baud(baud);
  }

 protected:
  StreamDriver(const DriverOptions& options, Scanner scan)
      : timing_(options), framer_(timing_.rate()), scan_(scan) {}

  /// A whole frame of the protocol.
  virtual void on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) = 0;

  /// No more bytes of the oldest frame will come: frames that wait behind it come out.
  void look_behind(Output& out) {
    framer_.look_behind([] { return true; }, scan_, teller(out));
  }

  Timing timing_;

 private:
  auto teller(Output& out) {
    return
        [this, &out](wire::Bytes frame, const Arrival& arrival) { on_frame(frame, arrival, out); };
  }

  TimedFramer<Capacity> framer_;
  Scanner scan_;
};

}  // namespace drydock::device
