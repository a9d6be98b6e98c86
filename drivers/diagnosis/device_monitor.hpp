#pragma once

#include "drivers/device/life_cycle.hpp"
#include "drivers/diagnosis/line_monitor.hpp"
#include "drivers/measurement/measurement.hpp"

namespace drydock::diagnosis {

/// All monitors of one device, for every protocol: its line, its times, its values. Sans-I/O; no
/// allocation after construction.
class DeviceMonitor {
 public:
  /// The sink must outlive the monitor.
  DeviceMonitor(const Expected& expected, SymptomSink& to) : line_(expected, to) {}

  void take(const measurement::Measurement&) {}
  /// Call it about every look_period.
  void look(const device::Health& health, Stamp now) { line_.look(health, now); }

 private:
  LineMonitor line_;
};

inline constexpr std::chrono::milliseconds look_period{250};

}  // namespace drydock::diagnosis
