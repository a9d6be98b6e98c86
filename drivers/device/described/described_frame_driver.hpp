#pragma once

#include <vector>

#include "drivers/device/bus/source_filter.hpp"
#include "drivers/device/described/publish_measured.hpp"
#include "drivers/device/described/sample_group.hpp"
#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/device/timing.hpp"
#include "drivers/wire/described/frame_codec.hpp"

namespace drydock::device {

/// The driver of every sensor on a CAN bus that a description and its DBC file describe. Frames
/// that belong together become one measurement. A damaged frame is never a value, and neither is
/// one whose counter stood still. It says nothing to the bus. On J1939 it listens to one sender.
class DescribedFrameDriver final : public FrameDriver {
 public:
  explicit DescribedFrameDriver(const DriverOptions& options);

  void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) override;
  void tick(Stamp, Output&) override {}
  std::optional<Stamp> deadline() const override { return {}; }
  void restart(Stamp now, Output& out) override;
  const wire::StreamCounters& counters() const override { return decoder_.counters(); }
  std::size_t held_bytes() const override { return 0; }
  void set_bitrate(unsigned bitrate) override { timing_.set_bitrate(bitrate); }
  void set_provenance(measurement::Provenance provenance) override {
    timing_.set_provenance(provenance);
  }

 private:
  bool is_ours(const wire::CanFrame& frame, Stamp at);
  bool counts_on(Output& out);
  void join(const wire::CanFrame& frame, Stamp at, Output& out);

  DriverOptions options_;
  wire::described::FrameDecoder decoder_;
  Timing timing_;
  SourceFilter source_;
  wire::described::Record record_;
  wire::described::Readings readings_;
  std::vector<wire::dbc::FrameCounter> counters_;  ///< of each message
  std::vector<SampleGroup> groups_;
  std::vector<std::size_t> group_of_;  ///< each message
  MeasuredPublisher publisher_;
};

}  // namespace drydock::device
