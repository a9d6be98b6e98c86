#include "hil/score/relative_errors.hpp"

#include "hil/score/attitude.hpp"
#include "hil/score/lengths.hpp"

namespace drydock::score {
namespace {

using Eigen::Vector3d;

bool has_attitudes(const Pair& pair) {
  return pair.estimate.angles.allFinite() && pair.truth.angles.allFinite();
}

/// The way from one state to another, in the body axes of the first if both sides have them.
Vector3d way(const State& from, const State& to, bool in_body) {
  const Vector3d ned = to.position_ned - from.position_ned;
  return in_body ? Vector3d(attitude_of(from)->conjugate() * ned) : ned;
}

Eigen::Quaterniond turn(const State& from, const State& to) {
  return attitude_of(from)->conjugate() * *attitude_of(to);
}

class RelativeErrors {
 public:
  void add(const Pair& a, const Pair& b) {
    const bool turned = has_attitudes(a) && has_attitudes(b);
    const bool in_body = turned && (a.estimate.position_ned - b.estimate.position_ned).allFinite();
    const auto length =
        told_length(way(a.estimate, b.estimate, in_body) - way(a.truth, b.truth, in_body));
    way_.add(length);
    if (turned) turn_.add(angle_deg(turn(a.estimate, b.estimate), turn(a.truth, b.truth)));
    if (length || turned) ++pairs_;
  }
  void write(Errors& errors) const {
    errors.rpe_pairs = pairs_;
    errors.rpe_m = way_.result();
    errors.rpe_deg = turn_.result();
  }

 private:
  LengthSum way_, turn_;
  std::uint64_t pairs_ = 0;
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
