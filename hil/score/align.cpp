#include "hil/score/align.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <optional>

namespace drydock::score {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Means {
  Vector3d estimate = Vector3d::Zero(), truth = Vector3d::Zero();
};

Means means_of(const std::vector<Pair>& pairs) {
  Means means;
  for (const Pair& pair : pairs) {
    means.estimate += pair.estimate.position_ned;
    means.truth += pair.truth.position_ned;
  }
  const auto n = static_cast<double>(pairs.size());
  return {means.estimate / n, means.truth / n};
}

/// Sum of truth times estimate, both from their means.
Matrix3d cross_of(const std::vector<Pair>& pairs, const Means& means) {
  Matrix3d cross = Matrix3d::Zero();
  for (const Pair& pair : pairs)
    cross += (pair.truth.position_ned - means.truth) *
             (pair.estimate.position_ned - means.estimate).transpose();
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

/// Empty: the pairs do not tell it.
std::optional<Matrix3d> turn_of(const std::vector<Pair>& pairs, const Means& means,
                                Alignment alignment) {
  const Matrix3d cross = cross_of(pairs, means);
  if (pairs.size() < 3 || !(cross.norm() > 1e-12)) return {};
  return alignment == Alignment::yaw ? turn_about_down(cross) : any_turn(cross);
}

void turn(Pose& pose, const Matrix3d& by, const Vector3d& from, const Vector3d& to) {
  pose.position_ned = to + by * (pose.position_ned - from);
  if (pose.body_to_ned) pose.body_to_ned = Eigen::Quaterniond(by) * *pose.body_to_ned;
  if (pose.covariance_m2) pose.covariance_m2 = by * *pose.covariance_m2 * by.transpose();
}

}  // namespace

bool align(std::vector<Pair>& pairs, Alignment alignment) {
  if (pairs.empty() || alignment == Alignment::none) return true;
  const bool turns = alignment != Alignment::start;
  const Means means =
      turns ? means_of(pairs)
            : Means{pairs.front().estimate.position_ned, pairs.front().truth.position_ned};
  const auto by = turns ? turn_of(pairs, means, alignment) : Matrix3d(Matrix3d::Identity());
  for (Pair& pair : pairs)
    turn(pair.estimate, by.value_or(Matrix3d::Identity()), means.estimate, means.truth);
  return by.has_value();
}

}  // namespace drydock::score
