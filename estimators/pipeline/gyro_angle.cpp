#include "estimators/pipeline/gyro_angle.hpp"

namespace drydock::pipeline {

using measurement::seconds;
using measurement::Stamp;

void GyroAngle::add(Stamp at, double rate_radps) {
  const double angle =
      empty() ? 0 : now() + 0.5 * (rate() + rate_radps) * seconds(at - newest().at);
  samples_[count_++ % capacity] = {at, rate_radps, angle};
}

Stamp GyroAngle::oldest() const { return sample(count_ > capacity ? count_ - capacity : 0).at; }

double GyroAngle::at(Stamp time) const {
  if (time >= newest().at) return now() + rate() * seconds(time - newest().at);
  std::size_t later = count_ - 1;
  while (sample(later - 1).at > time) --later;
  const Sample &before = sample(later - 1), &after = sample(later);
  const double share = seconds(time - before.at) / seconds(after.at - before.at);
  return before.angle + share * (after.angle - before.angle);
}

}  // namespace drydock::pipeline
