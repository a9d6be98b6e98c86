#include "hil/sensor/noise.hpp"

#include <cmath>

namespace drydock::sensor {
namespace {

RandomStream stream(const ErrorSource& source, std::string_view part) {
  return {source.seed, source.device, source.stream(part)};
}

Vector3d normals(RandomStream& random, int axes) {
  if (axes == 1) return {random.normal(), 0, 0};
  return random.normal3();
}

}  // namespace

WhiteNoise::WhiteNoise(const rig_config::SensorErrors& errors, double rate_hz,
                       const ErrorSource& source)
    : random_(stream(source, "noise")) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    sigma_[static_cast<Eigen::Index>(axis)] =
        std::hypot(errors.noise[axis], errors.noise_density[axis] * std::sqrt(rate_hz));
}

Vector3d WhiteNoise::next(int axes) { return sigma_.cwiseProduct(normals(random_, axes)); }

BiasInstability::BiasInstability(const rig_config::SensorErrors& errors, const ErrorSource& source)
    : sigma_(vector(errors.bias_instability)),
      correlation_s_(errors.correlation_s),
      random_(stream(source, "bias instability")) {}

void BiasInstability::begin(int axes) { value_ = sigma_.cwiseProduct(normals(random_, axes)); }

void BiasInstability::step(std::chrono::nanoseconds dt, int axes) {
  if (dt != dt_) {
    dt_ = dt;
    const double elapsed = measurement::seconds(dt) / correlation_s_;
    memory_ = std::exp(-elapsed);
    renewal_ = std::sqrt(-std::expm1(-2 * elapsed));
  }
  value_ = memory_ * value_ + renewal_ * sigma_.cwiseProduct(normals(random_, axes));
}

RandomWalk::RandomWalk(const rig_config::SensorErrors& errors, const ErrorSource& source)
    : density_(vector(errors.random_walk)), random_(stream(source, "random walk")) {}

void RandomWalk::step(std::chrono::nanoseconds dt, int axes) {
  value_ += std::sqrt(measurement::seconds(dt)) * density_.cwiseProduct(normals(random_, axes));
}

Vector3d Drift::at(Stamp time, int axes) {
  const auto dt = time - last_;
  last_ = time;
  if (!begun_) {
    begun_ = true;
    if (!instability_.is_silent()) instability_.begin(axes);
  } else {
    if (!instability_.is_silent()) instability_.step(dt, axes);
    if (!walk_.is_silent()) walk_.step(dt, axes);
  }
  return instability_.value() + walk_.value();
}

}  // namespace drydock::sensor
