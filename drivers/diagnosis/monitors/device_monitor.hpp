#pragma once

#include "drivers/device/life_cycle.hpp"
#include "drivers/diagnosis/monitors/line_length.hpp"
#include "drivers/diagnosis/monitors/line_monitor.hpp"
#include "drivers/diagnosis/monitors/time_monitor.hpp"
#include "drivers/diagnosis/monitors/value_monitor.hpp"

namespace drydock::diagnosis {

/// All monitors of one device, for every protocol: its line, its times, its values. Sans-I/O; no
/// allocation after construction.
class DeviceMonitor {
 public:
  /// The sink must outlive the monitor.
  DeviceMonitor(const Expected& expected, SymptomSink& to)
      : line_(expected, to), times_(expected, to), values_(expected, to) {}

  /// `host`: what this computer may have added to its arrival.
  void take(const measurement::Measurement& measurement, HostLate host = {}) {
    const std::uint32_t stream = stream_of(measurement);
    last_ = measurement::origin_of(measurement).received_at;
    const bool same = values_.take(stream, measurement);
    times_.note_length(stream, line_length_of(measurement), last_);
    times_.take(stream, measurement::origin_of(measurement), same, host);
  }
  /// Call it about every look_period.
  void look(const device::Vitals& vitals, Stamp now) {
    // A shorter silence is part of the pattern.
    if (vitals.state != device::State::streaming && now - last_ > away) interrupt();
    line_.look(vitals, now, !times_.loses_from_start());
    times_.look(now);
    values_.look(now);
  }
  /// The device was away: the next intervals mean nothing.
  void interrupt() {
    times_.interrupt();
    values_.interrupt();
  }
  /// This program stood still until `now`.
  void stand_still(Stamp now) {
    interrupt();
    line_.interrupt(now);
  }
  void set_antenna(Antenna antenna, Stamp now) { values_.set_antenna(antenna, now); }

 private:
  static constexpr std::chrono::seconds away{3};

  LineMonitor line_;
  TimeMonitor times_;
  ValueMonitor values_;
  Stamp last_{};  ///< the latest measurement
};

inline constexpr std::chrono::milliseconds look_period{250};

}  // namespace drydock::diagnosis
