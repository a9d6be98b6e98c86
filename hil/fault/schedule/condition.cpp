#include "hil/fault/schedule/condition.hpp"

#include "rig_config/fault_quantity.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::fault {

namespace {

Eigen::Vector3d vector(const std::array<double, 3>& amount) {
  return {amount[0], amount[1], amount[2]};
}

void disturb(sensor::Disturbance& quantity, const InForce& now) {
  const FaultConfig& fault = *now.fault;
  const Eigen::Vector3d amount = vector(fault.amount);
  switch (fault.kind) {
    case FaultKind::bias: quantity.bias = amount; break;
    case FaultKind::wrong: quantity.wrong = amount; break;
    case FaultKind::drift:
      quantity.drift = {amount, now.since, measurement::from_seconds(fault.within_s)};
      break;
    case FaultKind::spike:
      quantity.spike = amount;
      quantity.spike_probability = fault.probability;
      break;
    default: break;
  }
}

}  // namespace

emulate::Condition condition_under(const std::vector<InForce>& faults,
                                   rig_config::DeviceKind kind) {
  emulate::Condition is;
  for (const InForce& now : faults) {
    const FaultConfig& fault = *now.fault;
    const double amount = fault.amount[0];
    is.troubles.push_back({fault.kind, now.since, amount});
    switch (fault.kind) {
      case FaultKind::stuck:
        is.stuck_at = now.since;
        is.primary.stuck = is.secondary.stuck = true;
        break;
      case FaultKind::noise: is.primary.noise_times = is.secondary.noise_times = amount; break;
      case FaultKind::slow: is.times_fewer = amount; break;
      case FaultKind::clock_step: is.clock.step = measurement::from_seconds(amount); break;
      case FaultKind::clock_drift:
        is.clock.rate = amount * 1e-6;
        is.clock.since = now.since;
        break;
      default:
        disturb(rig_config::is_secondary(kind, fault.quantity) ? is.secondary : is.primary, now);
    }
  }
  return is;
}

}  // namespace drydock::fault
