#pragma once

#include "drivers/device/driver.hpp"
#include "drivers/device/timing.hpp"

namespace drydock::device {

/// The common parts of drivers on byte links: the framer and the timing.
template <std::size_t Capacity>
class StreamDriver : public ByteDriver {
 public:
  void tick(Stamp, Output&) override {}
  std::optional<Stamp> deadline() const override { return {}; }
  void restart(Stamp, Output&) override { framer_.reset(); }
  const wire::StreamCounters& counters() const final { return framer_.counters(); }
  std::size_t held_bytes() const final { return framer_.held(); }
  void set_provenance(measurement::Provenance provenance) final {
    timing_.set_provenance(provenance);
  }
  void set_baud(unsigned baud) final { timing_.set_baud(baud); }

 protected:
  explicit StreamDriver(const DriverOptions& options) : timing_(options) {}

  wire::Framer<Capacity> framer_;
  Timing timing_;
};

}  // namespace drydock::device
