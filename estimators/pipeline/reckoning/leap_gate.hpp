#pragma once

#include <cstdint>
#include <optional>

#include "drivers/measurement/stamp.hpp"

namespace drydock::pipeline {

/// How far a value of a vehicle can get, and what is an angle.
struct LeapLimits {
  double change_per_s = 0;   ///< what a vehicle makes of it at most, per second
  double change_per_s2 = 0;  ///< likewise, where the rate is told and goes on
  double least = 0;          ///< a smaller leap is no concern
  bool angle = false;        ///< rad: it wraps
};

/// Recognises values of one sensor that leap away from where a vehicle can be, as the gates of
/// docs/estimators/integrity.md do for gyros. It learns the noise from the differences of samples.
/// A leap that lasts is believed and called a step. Allocates nothing, throws nothing.
class LeapGate {
 public:
  enum class Verdict : std::uint8_t {
    good,
    wild,    ///< not to be used
    stepped  ///< to be used, but no vehicle moves like this: the sensor was wrong, or is
  };

  explicit LeapGate(const LeapLimits& limits) : limits_(limits) {}

  /// `rate`: how the value changes at present, per second. A value after `longest_silence_s` or
  /// from the past begins anew.
  Verdict judge(measurement::Stamp at, double value, double rate = 0);

  /// The sum of the steps that were believed, in the unit of the value; 0: the sensor came back.
  double stepped() const { return stepped_; }
  /// For how long its values have been wild; 0: the last one was good.
  double unknown_s(measurement::Stamp at) const;

  /// Leaps in a row that agree, and the time that they take, make a step.
  static constexpr int step_samples = 5;
  static constexpr double step_s = 3, longest_silence_s = 5;

 private:
  struct Point {
    measurement::Stamp at;
    double value;
  };
  double difference(double to, double from) const;
  double reach(double dt) const;
  bool step_lasts(const Point& now, double rate);
  Verdict take(const Point& now, double change);

  LeapLimits limits_;
  std::optional<Point> good_, leapt_;                 ///< the last good one; the newest that leapt
  measurement::Stamp leapt_first_{}, leapt_since_{};  ///< behind the last good one; that agree
  int agreeing_ = 0;
  double usual_ = 0, stepped_ = 0;  ///< usual_: mean absolute difference from what was expected
  int learned_ = 0;
};

}  // namespace drydock::pipeline
