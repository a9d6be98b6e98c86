#pragma once

#include "drivers/diagnosis/symptom.hpp"
#include "estimators/consistency/consistency.hpp"

namespace drydock::host {

/// What the monitors of single devices see. The judge hears all of it; the cross-checks hear whose
/// own samples show that their values are wrong, or of another time.
class OwnSigns final : public diagnosis::SymptomSink {
 public:
  OwnSigns(diagnosis::SymptomSink& judge, consistency::Consistency& cross_checks)
      : judge_(judge), cross_checks_(cross_checks) {}

  void see(const diagnosis::Symptom& symptom) override {
    judge_.see(symptom);
    if (misleads(symptom.sign)) cross_checks_.doubt(symptom.device, symptom.since, symptom.at);
  }

 private:
  static bool misleads(diagnosis::Sign sign) {
    using enum diagnosis::Sign;
    switch (sign) {
      case stuck:
      case noisy:
      case wild_samples:
      case wild_unequal:
      case impossible:
      case out_of_range:
      case step:
      case late:
      case bunched: return true;
      default: return false;
    }
  }

  diagnosis::SymptomSink& judge_;
  consistency::Consistency& cross_checks_;
};

}  // namespace drydock::host
