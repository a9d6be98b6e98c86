#include "hil/steer/thrust_allocation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace drydock::steer {
namespace {

Eigen::MatrixXd configuration_of(const std::vector<motion::Thruster>& thrusters) {
  Eigen::MatrixXd columns(6, static_cast<Eigen::Index>(thrusters.size()));
  for (std::size_t i = 0; i < thrusters.size(); ++i)
    columns.col(static_cast<Eigen::Index>(i)) = thrusters[i].of_one_newton();
  return columns;
}

}  // namespace

ThrustAllocation::ThrustAllocation(std::vector<motion::Thruster> thrusters)
    : thrusters_(std::move(thrusters)), configuration_(configuration_of(thrusters_)) {}

std::vector<double> ThrustAllocation::pushes(const measurement::BodyWrench& wrench) const {
  Eigen::Matrix<double, 6, 1> wanted;
  wanted << wrench.force_n, wrench.moment_nm;
  const Eigen::VectorXd exact = configuration_.solve(wanted);
  double share = 1;
  for (std::size_t i = 0; i < thrusters_.size(); ++i) {
    const double push = exact[static_cast<Eigen::Index>(i)];
    if (push != 0) share = std::min(share, thrusters_[i].limit_n(push) / std::abs(push));
  }
  std::vector<double> pushes;
  for (const double push : exact) pushes.push_back(share * push);
  return pushes;
}

}  // namespace drydock::steer
