#pragma once

#include <memory>
#include <vector>

#include "drivers/diagnosis/monitors/antenna.hpp"
#include "drivers/diagnosis/symptom.hpp"
#include "drivers/measurement/measurement.hpp"
#include "estimators/consistency/sensor.hpp"

/// Cross-checks of sensors: what several devices of one vehicle say must fit together. Pure: no
/// clock, no I/O, no allocation after construction. docs/estimators/consistency.md
namespace drydock::consistency {

class Checks;

/// All cross-checks of a rig.
class Consistency {
 public:
  /// `sensors`: in the order of the rig. The sink must outlive the checks.
  Consistency(const std::vector<Sensor>& sensors, diagnosis::SymptomSink& to);
  ~Consistency();

  void take(const measurement::Measurement& measurement);

  /// The device's own samples show that its values are wrong since then; repeat it while it lasts.
  /// It is no reference for the others.
  void doubt(std::uint16_t device, diagnosis::Stamp since, diagnosis::Stamp now);

  /// Where the receiver's antenna is by the way down that a DVL tells.
  diagnosis::Antenna antenna(std::uint16_t receiver) const;

  /// Repeats the signs that last. Call it about as often as the judge settles.
  void tell(diagnosis::Stamp now) const;

 private:
  std::unique_ptr<Checks> checks_;
};

}  // namespace drydock::consistency
