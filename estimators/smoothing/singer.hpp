#pragma once

#include <Eigen/Core>

namespace drydock::smoothing {

/// What a time does to a value (m or rad), its rate and its acceleration, of which the last is a
/// Gauss-Markov process.
struct SingerStep {
  Eigen::Matrix3d transition, noise;
};

/// R. A. Singer, Estimating optimal tracking filter performance for manned maneuvering targets,
/// IEEE Trans. AES-6 (1970) 473. `density`: the rate wanders by it per sqrt(s) over long times.
/// `correlation_s` > 0: how long an acceleration lasts. Towards 0 the rate is a random walk.
SingerStep singer_step(double density, double correlation_s, double dt);

/// One sigma of the acceleration, whenever it is looked at.
double singer_acceleration(double density, double correlation_s);

}  // namespace drydock::smoothing
