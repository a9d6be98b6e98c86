#include "hil/score/nees.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace drydock::score {

void NeesSum::add(const Eigen::Vector3d& error, const std::optional<Eigen::Matrix3d>& covariance) {
  if (!covariance) return;
  std::vector<Eigen::Index> told;
  for (Eigen::Index i = 0; i < 3; ++i)
    if (!std::isnan(error[i]) && !std::isnan((*covariance)(i, i))) told.push_back(i);
  if (told.empty()) return;
  ++covariances_;
  const Eigen::VectorXd part = error(told);
  const Eigen::LLT<Eigen::MatrixXd> root((*covariance)(told, told));
  if (root.info() != Eigen::Success) return;
  const double normalised = part.dot(root.solve(part)) / static_cast<double>(told.size());
  if (!std::isfinite(normalised)) return;
  sum_ += normalised;
  ++pairs_;
}

Nees NeesSum::result() const {
  Nees nees{covariances_, pairs_, {}};
  if (pairs_ > 0) nees.mean = sum_ / static_cast<double>(pairs_);
  return nees;
}

}  // namespace drydock::score
