#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "drivers/measurement/measurement.hpp"
#include "estimators/pipeline/vehicle_limits.hpp"

namespace drydock::pipeline {

/// A step that no vehicle makes and that stays is one of the sensor: rad/s and m/s2, body axes. The
/// sigmas, each axis, say how well it is known.
struct ImuStep {
  Eigen::Vector3d rate = Eigen::Vector3d::Zero(), force = Eigen::Vector3d::Zero();
  double rate_sigma = 0, force_sigma = 0;
  double turn_sigma = 0;  ///< of the turn over the samples that were not used, rad
  bool thawed = false;    ///< the sensor was stuck, and all its earlier steps are over
};

/// Recognises samples of an IMU that no vehicle can cause: (I2) to (I4) of
/// docs/estimators/integrity.md. It learns the noise of the IMU from the differences of successive
/// samples. Allocates nothing, throws nothing.
class ImuGate {
 public:
  enum class Verdict : std::uint8_t {
    good,
    wild,    ///< do not use it
    stepped  ///< use it: step() stays
  };

  explicit ImuGate(const VehicleLimits& limits) : limits_(limits) {}

  /// Samples must be newer than the sample before.
  Verdict judge(const measurement::ImuSample& sample);
  const ImuStep& step() const { return step_; }  ///< of the last verdict `stepped`
  /// Forgets the last sample, because of a gap. The noise stays known.
  void forget();

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  struct Point {
    measurement::Stamp at;
    Vector6 values;
  };
  /// Samples in a row that leapt from the last good one to about one place.
  struct Run {
    Point newest;
    Vector6 leap;
    Vector6 unrest = Vector6::Zero();  ///< sum of the absolute changes between them
    int samples = 1;
    bool still = true;  ///< the quantity that leapt has exactly the same value in all of them
  };

  bool possible(const Vector6& values) const;
  bool reachable(const Point& from, const Point& to) const;
  bool goes_on(const Point& now) const;
  Verdict doubt(const Point& now);
  ImuStep step_of_run() const;
  ImuStep unused(const Vector6& leap) const;
  bool is_noise() const;
  bool frozen(const Vector6& values);
  void learn(const Point& now);
  void learn_noise(const Vector6& change);
  bool stands_still() const;
  Verdict believe(const Point& now, Verdict verdict);
  Vector6 usual_place() const;
  bool within_margin(const Vector6& leap) const;
  Vector6 margin() const;

  VehicleLimits limits_;
  std::optional<Point> good_;      ///< the last good sample
  std::array<Vector6, 5> lately_;  ///< the last good values, a ring
  std::size_t lately_count_ = 0;
  int still_ = 0;                        ///< changes in a row that are exactly zero
  std::optional<Run> run_;               ///< of samples elsewhere
  std::optional<Vector6> stuck_at_;      ///< the values of a sensor that leapt and then stood still
  Vector6 usual_ = Vector6::Zero();      ///< mean absolute difference of successive samples
  Vector6 trend_ = Vector6::Zero();      ///< mean difference: the vehicle's motion
  Vector6 off_trend_ = Vector6::Zero();  ///< mean absolute distance of a difference from it
  Vector6 turns_ = Vector6::Zero();  ///< share of the changes with another sign than the one before
  Vector6 change_ = Vector6::Zero();  ///< the last one that was not zero
  int learned_ = 0;
  ImuStep step_;
};

}  // namespace drydock::pipeline
