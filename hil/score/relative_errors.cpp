#include "hil/score/relative_errors.hpp"

#include "hil/score/lengths.hpp"

namespace drydock::score {
namespace {

using Eigen::Vector3d;

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

}  // namespace

void add_relative_errors(const std::vector<Pair>& pairs, std::chrono::nanoseconds interval,
                         Errors& errors) {
  const double most_off = rpe_tolerance * measurement::seconds(interval);
  RelativeErrors relative;
  std::size_t end = 0;
  for (const Pair& pair : pairs) {
    const auto too_late_s = [&](std::size_t i) {
      return measurement::seconds(pairs[i].truth.at - pair.truth.at - interval);
    };
    const auto off = [&](std::size_t i) { return std::abs(too_late_s(i)); };
    while (end + 1 < pairs.size() && off(end + 1) <= off(end)) ++end;
    if (end + 1 == pairs.size() && too_late_s(end) < 0) break;  // the nearest one would come later
    if (&pairs[end] > &pair && off(end) <= most_off) relative.add(pair, pairs[end]);
  }
  relative.write(errors);
}

}  // namespace drydock::score
