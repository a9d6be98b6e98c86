#include "hil/score/align.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <optional>

#include "hil/score/attitude.hpp"
#include "hil/score/turned.hpp"

namespace drydock::score {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Of the positions that both sides of a pair tell; 0 along an axis that none does.
struct Means {
  Vector3d estimate = Vector3d::Zero(), truth = Vector3d::Zero();
};

Vector3d error_of(const Pair& pair) { return pair.estimate.position_ned - pair.truth.position_ned; }

bool tells_horizontal(const Pair& pair) { return !error_of(pair).head<2>().hasNaN(); }
bool tells_all(const Pair& pair) { return !error_of(pair).hasNaN(); }

Means means_of(const std::vector<Pair>& pairs) {
  Means means;
  Vector3d counts = Vector3d::Zero();
  for (const Pair& pair : pairs) {
    const Eigen::Array3d is_told = (!error_of(pair).array().isNaN()).cast<double>();
    counts += is_told.matrix();
    means.estimate += (is_told * or_zero(pair.estimate.position_ned).array()).matrix();
    means.truth += (is_told * or_zero(pair.truth.position_ned).array()).matrix();
  }
  const Vector3d n = counts.cwiseMax(1);
  return {means.estimate.cwiseQuotient(n), means.truth.cwiseQuotient(n)};
}

/// The first place along each axis.
Means start_of(const std::vector<Pair>& pairs) {
  Means start;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto first = std::ranges::find_if(
        pairs, [i](const Pair& pair) { return !std::isnan(error_of(pair)[i]); });
    if (first == pairs.end()) continue;
    start.estimate[i] = first->estimate.position_ned[i];
    start.truth[i] = first->truth.position_ned[i];
  }
  return start;
}

/// Sum of truth times estimate, both from their means.
Matrix3d cross_of(const std::vector<Pair>& pairs, const Means& means) {
  Matrix3d cross = Matrix3d::Zero();
  for (const Pair& pair : pairs)
    if (tells_horizontal(pair))
      cross += or_zero(pair.truth.position_ned - means.truth) *
               or_zero(pair.estimate.position_ned - means.estimate).transpose();
  return cross;
}

Matrix3d turn_about_down(const Matrix3d& cross) {
  const double angle = std::atan2(cross(1, 0) - cross(0, 1), cross(0, 0) + cross(1, 1));
  return Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
}

Matrix3d any_turn(const Matrix3d& cross) {
  const Eigen::JacobiSVD<Matrix3d> svd(cross, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Vector3d signs{1, 1, svd.matrixU().determinant() * svd.matrixV().determinant() < 0 ? -1. : 1.};
  return svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
}

struct Turn {
  Matrix3d by = Matrix3d::Identity();
  std::string note;
};

Turn turn_of(const std::vector<Pair>& pairs, const Means& means, Alignment alignment) {
  const Matrix3d cross = cross_of(pairs, means);
  if (std::ranges::count_if(pairs, tells_horizontal) < 3 || !(cross.norm() > 1e-12))
    return {Matrix3d::Identity(),
            "the turn of the alignment is not determined: fewer than three estimates of a place "
            "with a truth, or no movement; they were only shifted, and the shift takes of the "
            "error what it can"};
  if (alignment == Alignment::yaw) return {turn_about_down(cross), {}};
  if (std::ranges::all_of(pairs, tells_all)) return {any_turn(cross), {}};
  return {turn_about_down(cross),
          "the alignment turned about the vertical alone: not every estimate tells all three axes "
          "of its position"};
}

/// An attitude without all three angles can be turned about the vertical alone.
void turn_attitude(State& state, const Matrix3d& by) {
  const auto before = attitude_of(state);
  if (!before) {
    state.angles.z() += std::atan2(by(1, 0), by(0, 0));
    return;
  }
  const Matrix3d turns_before = angles_by_turns(state.angles).inverse();
  state.angles = angles_of(Eigen::Quaterniond(by) * *before);
  if (state.angles_rad2)
    state.angles_rad2 =
        turned(angles_by_turns(state.angles) * by * turns_before, state.angles_rad2);
}

void move(State& state, const Matrix3d& by, const Means& means) {
  state.position_ned = means.truth + turned_vector(by, state.position_ned - means.estimate);
  if (by == Matrix3d::Identity()) return;
  turn_attitude(state, by);
  state.position_m2 = turned(by, state.position_m2);
  if (state.velocity_in_body) return;
  state.velocity = turned_vector(by, state.velocity);
  state.velocity_m2ps2 = turned(by, state.velocity_m2ps2);
}

}  // namespace

std::string align(std::vector<Pair>& pairs, Alignment alignment) {
  if (pairs.empty() || alignment == Alignment::none) return {};
  if (std::ranges::all_of(pairs,
                          [](const Pair& pair) { return error_of(pair).array().isNaN().all(); }))
    return "the alignment moved nothing: it goes by positions, and there are none";
  const bool turns = alignment != Alignment::start;
  const Means means = turns ? means_of(pairs) : start_of(pairs);
  const Turn turn = turns ? turn_of(pairs, means, alignment) : Turn{};
  for (Pair& pair : pairs) move(pair.estimate, turn.by, means);
  return turn.note;
}

}  // namespace drydock::score
