#include "hil/score/errors.hpp"

#include <Eigen/Cholesky>
#include <cmath>

#include "hil/score/lengths.hpp"
#include "hil/score/relative_errors.hpp"

namespace drydock::score {
namespace {

using Eigen::Vector3d;

void add_nees(const std::vector<Pair>& pairs, Errors& errors) {
  double sum = 0;
  for (const Pair& pair : pairs) {
    if (!pair.estimate.covariance_m2) continue;
    ++errors.covariances;
    const Vector3d error = pair.estimate.position_ned - pair.truth.position_ned;
    const Eigen::LLT<Eigen::Matrix3d> root(*pair.estimate.covariance_m2);
    if (root.info() != Eigen::Success) continue;
    const double normalised = error.dot(root.solve(error)) / 3;
    if (!std::isfinite(normalised)) continue;
    sum += normalised;
    ++errors.nees_pairs;
  }
  if (errors.nees_pairs > 0) errors.nees = sum / static_cast<double>(errors.nees_pairs);
}

}  // namespace

Errors errors_of(const std::vector<Pair>& pairs, std::chrono::nanoseconds interval) {
  Errors errors;
  errors.pairs = pairs.size();
  if (pairs.empty()) return errors;
  LengthSum all, horizontal, vertical, turn;
  for (const Pair& pair : pairs) {
    const Vector3d error = pair.estimate.position_ned - pair.truth.position_ned;
    all.add(error.norm());
    horizontal.add(error.head<2>().norm());
    vertical.add(std::abs(error.z()));
    errors.end_m = error.norm();
    if (has_attitudes(pair))
      turn.add(angle_deg(*pair.estimate.body_to_ned, *pair.truth.body_to_ned));
  }
  errors.ate_m = *all.result();
  errors.horizontal_rms_m = horizontal.result()->rms;
  errors.vertical_rms_m = vertical.result()->rms;
  errors.attitude_deg = turn.result();
  add_nees(pairs, errors);
  add_relative_errors(pairs, interval, errors);
  return errors;
}

}  // namespace drydock::score
