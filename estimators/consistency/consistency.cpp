#include "estimators/consistency/consistency.hpp"

#include "estimators/consistency/checks.hpp"

namespace drydock::consistency {

Consistency::Consistency(const std::vector<Sensor>& sensors, diagnosis::SymptomSink& to)
    : checks_(std::make_unique<Checks>(sensors, to)) {}
Consistency::~Consistency() = default;

void Consistency::take(const measurement::Measurement& measurement) { checks_->take(measurement); }
void Consistency::doubt(std::uint16_t device, diagnosis::Stamp since, diagnosis::Stamp now) {
  checks_->doubt(device, since, now);
}
diagnosis::Antenna Consistency::antenna(std::uint16_t receiver) const {
  return checks_->antenna(receiver);
}
void Consistency::tell(diagnosis::Stamp now) const { checks_->tell(now); }

}  // namespace drydock::consistency
