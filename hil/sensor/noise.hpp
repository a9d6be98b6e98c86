#pragma once

#include <Eigen/Core>
#include <chrono>

#include "drivers/measurement/stamp.hpp"
#include "hil/sensor/constants.hpp"
#include "hil/sensor/random.hpp"

/// Random errors that change from sample to sample. Each process has its own random stream. `axes`
/// is 3, or 1 for a scalar quantity, which draws one number per sample instead of three.
namespace drydock::sensor {

using measurement::Stamp;

/// docs/sensors/errors.md (8): independent from sample to sample. A sample is the mean over 1 /
/// rate, so a density N gives the deviation N sqrt(rate), and the integral grows by N sqrt(t) at
/// any rate.
class WhiteNoise {
 public:
  WhiteNoise(const rig_config::SensorErrors& errors, double rate_hz, const ErrorSource& source);

  Vector3d next(int axes);
  bool is_silent() const { return sigma_.isZero(0); }
  const Vector3d& sigma() const { return sigma_; }

 private:
  Vector3d sigma_;
  RandomStream random_;
};

/// docs/sensors/errors.md (9): first-order Gauss-Markov process, stationary from the first sample.
class BiasInstability {
 public:
  BiasInstability(const rig_config::SensorErrors& errors, const ErrorSource& source);

  void step(std::chrono::nanoseconds dt, int axes);  ///< exact for any dt
  void begin(int axes);
  const Vector3d& value() const { return value_; }
  bool is_silent() const { return sigma_.isZero(0); }

 private:
  Vector3d sigma_, value_ = Vector3d::Zero();
  double correlation_s_;
  std::chrono::nanoseconds dt_{0};  ///< the interval for which the next two values hold
  double memory_ = 1, renewal_ = 0;
  RandomStream random_;
};

/// docs/sensors/errors.md (10): zero at the first sample; the variance grows with time.
class RandomWalk {
 public:
  RandomWalk(const rig_config::SensorErrors& errors, const ErrorSource& source);

  void step(std::chrono::nanoseconds dt, int axes);
  const Vector3d& value() const { return value_; }
  bool is_silent() const { return density_.isZero(0); }

 private:
  Vector3d density_, value_ = Vector3d::Zero();
  RandomStream random_;
};

/// Both slow processes at the times of the samples. The time of a gap counts too.
class Drift {
 public:
  Drift(const rig_config::SensorErrors& errors, const ErrorSource& source)
      : instability_(errors, source), walk_(errors, source) {}

  Vector3d at(Stamp time, int axes);  ///< in time order
  bool is_silent() const { return instability_.is_silent() && walk_.is_silent(); }

 private:
  BiasInstability instability_;
  RandomWalk walk_;
  bool begun_ = false;
  Stamp last_{};
};

}  // namespace drydock::sensor
