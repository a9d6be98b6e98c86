#pragma once

#include <utility>

#include "drivers/device/driver.hpp"
#include "drivers/device/timing.hpp"

namespace drydock::device {

/// The common parts of drivers on a CAN bus: the protocol's decoder and the timing.
template <class Protocol>
class BusDriver : public FrameDriver {
 public:
  void tick(Stamp, Output&) override {}
  std::optional<Stamp> deadline() const override { return {}; }
  void restart(Stamp, Output&) override {}
  const wire::StreamCounters& counters() const final { return decoder_.counters(); }
  std::size_t held_bytes() const final {
    const wire::StreamCounters& c = counters();
    return c.bytes_in - c.bytes_good - c.bytes_skipped;
  }
  void set_bitrate(unsigned bitrate) final { timing_.set_bitrate(bitrate); }
  void set_provenance(measurement::Provenance provenance) final {
    timing_.set_provenance(provenance);
  }

 protected:
  explicit BusDriver(const DriverOptions& options, typename Protocol::Decoder decoder = {})
      : decoder_(std::move(decoder)), timing_(options) {}

  typename Protocol::Decoder decoder_;
  Timing timing_;
};

}  // namespace drydock::device
