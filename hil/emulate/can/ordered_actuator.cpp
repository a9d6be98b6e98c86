#include "hil/emulate/can/ordered_actuator.hpp"

#include "hil/sensor/ideal.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::emulate {

OrderedActuator::OrderedActuator(const DeviceSetup& setup, int number)
    : trajectory_(setup.trajectory),
      condition_(setup.condition),
      vehicle_(motion::orders_of(setup.trajectory)),
      number_(number) {}

OrderedActuator::~OrderedActuator() {
  if (ordered_at_ && turns()) give(0, *ordered_at_);
}

void OrderedActuator::give(double value, Stamp at) {
  if (vehicle_ != nullptr) vehicle_->give(number_, value, at);
}

double OrderedActuator::within_limits(double value) const {
  return vehicle_ != nullptr ? vehicle_->within_limits(number_, value) : value;
}

bool OrderedActuator::order(double value, Stamp at) {
  ordered_at_ = at;
  const bool can = within_limits(value) == value;
  if (vehicle_ != nullptr) vehicle_->count(!can);
  if (condition_->stuck_at) {
    stop(*condition_->stuck_at);
  } else {
    const Trouble* late = condition_->under(FaultKind::delay);
    give(value, late != nullptr ? at + measurement::from_seconds(late->amount) : at);
  }
  return can;
}

void OrderedActuator::rest(Stamp at) {
  ordered_at_.reset();
  give(0, at);
}

void OrderedActuator::stop(Stamp at) {
  const auto stands = sensor::ideal_actuators(trajectory_.at(at));
  give(turns() ? 0 : value_of(stands, number_).value_or(0), at);
}

bool OrderedActuator::times_out(Stamp at, std::chrono::nanoseconds patience) {
  if (!ordered_at_ || at - *ordered_at_ <= patience) return false;
  ordered_at_.reset();
  return true;
}

}  // namespace drydock::emulate
