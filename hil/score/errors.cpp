#include "hil/score/errors.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "drivers/measurement/units.hpp"

namespace drydock::score {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

class LengthSum {
 public:
  void add(double length) {
    ++count_;
    square_ += length * length;
    sum_ += length;
    max_ = std::max(max_, length);
  }
  std::uint64_t count() const { return count_; }
  std::optional<Lengths> result() const {
    if (count_ == 0) return {};
    const auto n = static_cast<double>(count_);
    return Lengths{std::sqrt(square_ / n), sum_ / n, max_};
  }

 private:
  std::uint64_t count_ = 0;
  double square_ = 0, sum_ = 0, max_ = 0;
};

double angle_deg(const Quaterniond& a, const Quaterniond& b) {
  return a.angularDistance(b) * units::degrees_per_radian;
}

bool has_attitudes(const Pair& pair) { return pair.estimate.body_to_ned && pair.truth.body_to_ned; }

/// The way from one pose to another, in the body axes of the first if both sides have them.
Vector3d way(const Pose& from, const Pose& to, bool in_body) {
  const Vector3d ned = to.position_ned - from.position_ned;
  return in_body ? Vector3d(from.body_to_ned->conjugate() * ned) : ned;
}

class RelativeErrors {
 public:
  void add(const Pair& a, const Pair& b) {
    const bool turned = has_attitudes(a) && has_attitudes(b);
    way_.add((way(a.estimate, b.estimate, turned) - way(a.truth, b.truth, turned)).norm());
    if (!turned) return;
    turn_.add(angle_deg(a.estimate.body_to_ned->conjugate() * *b.estimate.body_to_ned,
                        a.truth.body_to_ned->conjugate() * *b.truth.body_to_ned));
  }
  void write(Errors& errors) const {
    errors.rpe_pairs = way_.count();
    errors.rpe_m = way_.result();
    errors.rpe_deg = turn_.result();
  }

 private:
  LengthSum way_, turn_;
};

/// Each pair with the first one that is at least `interval` later.
RelativeErrors relative_errors(const std::vector<Pair>& pairs, std::chrono::nanoseconds interval) {
  RelativeErrors errors;
  std::size_t end = 0;
  for (const Pair& pair : pairs) {
    while (end < pairs.size() && pairs[end].truth.at - pair.truth.at < interval) ++end;
    if (end == pairs.size()) break;
    errors.add(pair, pairs[end]);
  }
  return errors;
}

double mean_normalised(const std::vector<Pair>& pairs, std::uint64_t& count) {
  double sum = 0;
  for (const Pair& pair : pairs) {
    if (!pair.estimate.covariance_m2) continue;
    const Vector3d error = pair.estimate.position_ned - pair.truth.position_ned;
    const double normalised = error.dot(pair.estimate.covariance_m2->inverse() * error) / 3;
    if (!std::isfinite(normalised)) continue;
    sum += normalised;
    ++count;
  }
  return sum / static_cast<double>(count);
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
  std::uint64_t normalised = 0;
  const double nees = mean_normalised(pairs, normalised);
  if (normalised > 0) errors.nees = nees;
  relative_errors(pairs, interval).write(errors);
  return errors;
}

}  // namespace drydock::score
