#include "hil/score/known_covariance.hpp"

#include <array>

#include "drivers/measurement/covariance.hpp"
#include "hil/score/track.hpp"

namespace drydock::score {

bool is_of_nothing(double variance) { return variance < 0 || variance >= large_variance; }

std::array<bool, 3> angles_of_nothing(const Eigen::Matrix3d& turns, bool is_default) {
  if (turns.diagonal().minCoeff() >= large_variance && !is_default) return {};
  const bool level = is_of_nothing(turns(0, 0)) && is_of_nothing(turns(1, 1));
  return {level, level, is_of_nothing(turns(2, 2))};
}

KnownCovariance known_covariance(Eigen::Matrix3d covariance) {
  if (!covariance.allFinite()) return {{}, "is none: it has a number that is not finite"};
  const auto is_unknown = [&](Eigen::Index i) {
    return covariance(i, i) <= 0 || covariance(i, i) >= large_variance;
  };
  const std::array unknown{is_unknown(0), is_unknown(1), is_unknown(2)};
  if (unknown[0] && unknown[1] && unknown[2])
    return {{}, "is not known (a variance is not above 0 and below 1e6)"};
  for (Eigen::Index i = 0; i < 3; ++i) {
    if (!unknown.at(static_cast<std::size_t>(i))) continue;
    covariance.row(i).setZero();
    covariance.col(i).setZero();
  }
  if (const char* flaw = measurement::covariance_flaw(covariance))
    return {{}, std::string("is none: it ") + flaw};
  for (Eigen::Index i = 0; i < 3; ++i)
    if (unknown.at(static_cast<std::size_t>(i))) covariance(i, i) = untold()[i];
  return {covariance, {}};
}

}  // namespace drydock::score
