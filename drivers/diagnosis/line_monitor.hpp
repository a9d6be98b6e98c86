#pragma once

#include "drivers/device/health.hpp"
#include "drivers/diagnosis/expected.hpp"
#include "drivers/diagnosis/symptom.hpp"

namespace drydock::diagnosis {

/// Watches the line of one device: silence, lost ports, damaged frames, foreign bytes, CAN errors.
class LineMonitor {
 public:
  /// The sink must outlive the monitor.
  LineMonitor(const Expected& expected, SymptomSink& to) : expected_(expected), to_(to) {}

  void look(const device::Health& health, Stamp now);

 private:
  void see(Sign sign, Stamp since, Stamp now, double value, double limit, std::string_view quantity,
           std::string_view unit);

  Expected expected_;
  SymptomSink& to_;
  device::Health last_{};
  bool looked_ = false;
};

}  // namespace drydock::diagnosis
