#pragma once

#include <cstdint>
#include <string_view>

#include "drivers/diagnosis/sign.hpp"
#include "drivers/measurement/stamp.hpp"

namespace drydock::diagnosis {

using measurement::Stamp;

/// One monitor sees one sign on one device. The monitor repeats it while it lasts; `value` is what
/// it measured, `limit` what it allows.
struct Symptom {
  std::uint16_t device = 0;  ///< index in the rig
  Sign sign = Sign::silent;
  Stamp since{};                ///< when the sign began, as well as the monitor can tell
  Stamp at{};                   ///< when it was seen
  double value = 0, limit = 0;  ///< a bound of magnitudes is positive, whatever the value's sign
  std::string_view quantity;    ///< what was measured, with static storage: "roll rate"
  std::string_view unit;        ///< of value and limit, with static storage: "deg/s"
  std::string_view advice{};    ///< with static storage; empty: that of the cause
  double false_alarm = 1e-6;    ///< probability that a healthy device gives it in an hour
};

/// Takes what monitors see. No call allocates or throws.
class SymptomSink {
 public:
  virtual ~SymptomSink() = default;
  virtual void see(const Symptom& symptom) = 0;
};

}  // namespace drydock::diagnosis
