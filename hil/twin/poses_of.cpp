#include "hil/twin/poses_of.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace drydock::twin {
namespace {

using smoothing::TrackPoint;
using Points = std::vector<TrackPoint>;

/// The cubic of Hermite in the NED axes of the point before.
frame::Position position_at(const TrackPoint& a, const TrackPoint& b, double time_s) {
  const double h = b.time_s - a.time_s;
  if (!(h > 0)) return a.position;
  const double x = std::clamp((time_s - a.time_s) / h, 0.0, 1.0);
  const Eigen::Vector3d way = frame::ned_offset(a.position, b.position);
  return frame::at_ned_offset(a.position, x * x * (3 - 2 * x) * way +
                                              h * x * (1 - x) * (1 - x) * a.velocity_ned -
                                              h * x * x * (1 - x) * b.velocity_ned);
}

Eigen::Quaterniond attitude_of(const TrackPoint& point) {
  return frame::body_to_ned(point.attitude);
}

/// The mean of points close to each other: their sum, each with the nearer sign.
Eigen::Quaterniond mean_attitude(Points::const_iterator from, Points::const_iterator to) {
  const Eigen::Vector4d first = attitude_of(*from).coeffs();
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (auto point = from; point != to; ++point) {
    const Eigen::Vector4d q = attitude_of(*point).coeffs();
    sum += q.dot(first) < 0 ? Eigen::Vector4d(-q) : q;
  }
  return Eigen::Quaterniond(Eigen::Vector4d(sum.normalized()));
}

Eigen::Quaterniond attitude_at(const Points& track, double time_s, double half_s) {
  const auto from = std::ranges::lower_bound(track, time_s - half_s, {}, &TrackPoint::time_s);
  const auto to = std::ranges::upper_bound(track, time_s + half_s, {}, &TrackPoint::time_s);
  const auto points = std::distance(from, to);
  if (points > 1) return mean_attitude(from, to);
  const auto next = std::ranges::lower_bound(track, time_s, {}, &TrackPoint::time_s);
  if (next == track.begin()) return attitude_of(track.front());
  if (next == track.end()) return attitude_of(track.back());
  const auto& before = *std::prev(next);
  const double x = (time_s - before.time_s) / (next->time_s - before.time_s);
  return attitude_of(before).slerp(x, attitude_of(*next));
}

/// A spline needs lines between which it turns little: pose files allow 90 degrees.
constexpr double widest_turn_rad = 1;

/// Adds `b`, and before it as many poses on the way from the last one as keep each turn small.
void add_by_small_turns(motion::Poses& poses, const motion::Pose& b) {
  if (!poses.empty()) {
    const motion::Pose a = poses.back();
    const auto way = frame::ned_offset(a.position, b.position);
    const double turn_rad = a.body_to_ned.angularDistance(b.body_to_ned);
    const auto parts = std::lround(std::ceil(turn_rad / widest_turn_rad));
    for (long k = 1; k < parts; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(parts);
      poses.push_back({a.t_s + (b.t_s - a.t_s) * share,
                       frame::at_ned_offset(a.position, way * share),
                       a.body_to_ned.slerp(share, b.body_to_ned)});
    }
  }
  poses.push_back(b);
}

}  // namespace

motion::Poses poses_of(const Points& track, double every_s) {
  const double length_s = track.back().time_s - track.front().time_s;
  const auto steps = std::lround(length_s / every_s);
  if (steps < 2) throw std::runtime_error("the track is shorter than two steps of --every");
  const double step_s = length_s / static_cast<double>(steps);
  motion::Poses poses;
  for (long k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) * step_s, time_s = track.front().time_s + t;
    const auto next = std::ranges::upper_bound(track, time_s, {}, &TrackPoint::time_s);
    const auto b = next == track.end() ? std::prev(next) : next;
    const auto a = b == track.begin() ? b : std::prev(b);
    // At each end only half of the points within half a step are there, so fewer are taken.
    const double half_s = std::min({step_s / 2, t, length_s - t});
    add_by_small_turns(poses, {t, position_at(*a, *b, time_s), attitude_at(track, time_s, half_s)});
  }
  return poses;
}

}  // namespace drydock::twin
