#include "hil/sensor/imu_sampler.hpp"

#include "hil/sensor/ideal.hpp"

namespace drydock::sensor {

ImuSampler::ImuSampler(const motion::Trajectory& trajectory, const Mounting& mounting,
                       double rate_hz, bool means)
    : trajectory_(trajectory),
      mounting_(mounting),
      period_(measurement::from_seconds(1 / rate_hz)),
      means_(means) {}

measurement::ImuSample ImuSampler::at(motion::Stamp time) {
  const motion::Stamp from = time - period_;
  // The trajectory has no motion before its start.
  if (!means_ || from < trajectory_.start()) return ideal_imu(trajectory_, time, mounting_);
  if (!integrator_ || integrated_to_ != from) integrator_.emplace(trajectory_, from, mounting_);
  const Increments sum = integrator_->until(time);
  integrated_to_ = time;
  measurement::ImuSample sample;
  sample.origin.valid_at = time;
  sample.angular_rate = sum.angle / measurement::seconds(period_);
  sample.specific_force = sum.velocity / measurement::seconds(period_);
  return sample;
}

}  // namespace drydock::sensor
