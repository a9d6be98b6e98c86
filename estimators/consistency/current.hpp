#pragma once

#include <Eigen/Core>

namespace drydock::consistency {

/// What a log lacks to the velocity over ground: the current, constant over the Earth, and the
/// log's own offset, constant in the body. A Kalman filter of these four with a random walk, so an
/// across current that no turn has shown yet makes the speed uncertain, not wrong.
class Current {
 public:
  /// `offset_sigma_mps`: 1 sigma of the log's own offset beforehand.
  explicit Current(double offset_sigma_mps = usual_offset_mps);
  static constexpr double usual_offset_mps = 0.1;

  /// Along and across, m/s, at a heading from any zero.
  Eigen::Vector2d at(double heading) const;
  /// The same without the log's own offset.
  Eigen::Vector2d water_at(double heading) const;
  /// The log's own offset ahead, m/s: so much the log reads too little.
  double offset() const { return state_[2]; }
  double offset_sigma() const;
  /// Variance of the part along, (m/s)2.
  double variance(double heading) const;

  /// `lacking`: over ground less through water, m/s; its second part counts if `across`.
  void follow(const Eigen::Vector2d& lacking, bool across, double heading, double dt);

 private:
  using Row = Eigen::RowVector4d;
  static Row row(int axis, double heading);
  void update(double lacking, const Row& h);

  Eigen::Vector4d state_ = Eigen::Vector4d::Zero();  ///< current north, east; offset x, y
  Eigen::Matrix4d covariance_;
};

}  // namespace drydock::consistency
