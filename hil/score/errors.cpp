#include "hil/score/errors.hpp"

#include <cmath>

#include "hil/score/attitude.hpp"
#include "hil/score/lengths.hpp"
#include "hil/score/nees.hpp"
#include "hil/score/relative_errors.hpp"

namespace drydock::score {
namespace {

using Eigen::Vector3d;

/// The errors of one estimate. NaN: one of both does not say it.
struct Deviation {
  Vector3d position_m, angles_rad, velocity_mps;
};

/// The true velocity along the axes in which the estimate has it.
Vector3d true_velocity(const Pair& pair) {
  if (!pair.estimate.velocity_in_body) return pair.truth.velocity;
  const auto attitude = attitude_of(pair.truth);
  return attitude ? Vector3d(attitude->conjugate() * pair.truth.velocity) : untold();
}

Deviation deviation_of(const Pair& pair) {
  return {pair.estimate.position_ned - pair.truth.position_ned,
          turns_between(pair.truth.angles, pair.estimate.angles),
          pair.estimate.velocity - true_velocity(pair)};
}

std::optional<double> size(double part) {
  return std::isnan(part) ? std::nullopt : std::optional(std::abs(part));
}

std::optional<double> in_degrees(double angle) { return size(angle * units::degrees_per_radian); }

std::optional<double> horizontal(const Vector3d& position) {
  return size(position.head<2>().norm());
}

class ErrorSum {
 public:
  explicit ErrorSum(Errors& errors) : errors_(errors) {}

  void add(const Pair& pair) {
    const auto deviation = deviation_of(pair);
    count(deviation);
    errors_.velocity_in_body = pair.estimate.velocity_in_body;
    add_position(deviation.position_m);
    add_attitude(pair, deviation.angles_rad);
    velocity_.add(told_length(deviation.velocity_mps));
    position_nees_.add(deviation.position_m, pair.estimate.position_m2);
    attitude_nees_.add(deviation.angles_rad, pair.estimate.angles_rad2);
    velocity_nees_.add(deviation.velocity_mps, pair.estimate.velocity_m2ps2);
  }

  void write() const {
    errors_.ate_m = ate_.result();
    errors_.horizontal_rms_m = horizontal_.rms();
    errors_.vertical_rms_m = vertical_.rms();
    errors_.attitude_deg = turn_.result();
    errors_.roll_deg = roll_.result();
    errors_.pitch_deg = pitch_.result();
    errors_.heading_deg = heading_.result();
    errors_.velocity_mps = velocity_.result();
    errors_.position_nees = position_nees_.result();
    errors_.attitude_nees = attitude_nees_.result();
    errors_.velocity_nees = velocity_nees_.result();
  }

 private:
  void count(const Deviation& deviation) {
    Eigen::Matrix<double, part_names.size(), 1> parts;
    parts << deviation.position_m, deviation.angles_rad, deviation.velocity_mps;
    for (std::size_t i = 0; i < part_names.size(); ++i)
      if (!std::isnan(parts[static_cast<Eigen::Index>(i)])) ++errors_.told.at(i);
  }
  void add_position(const Vector3d& error) {
    const auto length = told_length(error);
    if (length) errors_.end_m = length;
    ate_.add(length);
    horizontal_.add(horizontal(error));
    vertical_.add(size(error.z()));
  }
  void add_attitude(const Pair& pair, const Vector3d& error) {
    roll_.add(in_degrees(error.x()));
    pitch_.add(in_degrees(error.y()));
    heading_.add(in_degrees(error.z()));
    const auto estimate = attitude_of(pair.estimate), truth = attitude_of(pair.truth);
    if (estimate && truth) turn_.add(angle_deg(*estimate, *truth));
  }

  Errors& errors_;
  LengthSum ate_, horizontal_, vertical_, turn_, roll_, pitch_, heading_, velocity_;
  NeesSum position_nees_, attitude_nees_, velocity_nees_;
};

}  // namespace

Errors errors_of(const std::vector<Pair>& pairs, std::chrono::nanoseconds interval) {
  Errors errors;
  errors.pairs = pairs.size();
  ErrorSum sum(errors);
  for (const Pair& pair : pairs) sum.add(pair);
  sum.write();
  add_relative_errors(pairs, interval, errors);
  return errors;
}

}  // namespace drydock::score
