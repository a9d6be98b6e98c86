#pragma once

#include <Eigen/Core>
#include <optional>

namespace drydock::consistency {

/// What a log lacks to the velocity over ground: the current, constant over the Earth, and the
/// log's own offset, constant in the body. Both change slowly. A least mean squares filter.
class Current {
 public:
  /// Along and across, m/s. Without a heading the current is taken as constant in the body.
  Eigen::Vector2d along(std::optional<double> heading) const;

  /// `error`: over ground less (through water + along()).
  void follow(const Eigen::Vector2d& error, std::optional<double> heading, double dt);

 private:
  Eigen::Vector2d earth_ = Eigen::Vector2d::Zero(), own_ = Eigen::Vector2d::Zero();
  double followed_s_ = 0;
};

}  // namespace drydock::consistency
