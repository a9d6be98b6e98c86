#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "hil/study/ensemble.hpp"
#include "hil/study/velocity/velocity_trial.hpp"

namespace drydock::study {

/// One experiment of the velocity study.
struct VelocityCase {
  std::string_view name;
  double coefficient_sigma;  ///< relative, of the vehicle that the methods know
  std::string_view what;     ///< short description
};

/// Cases that share truth and sensors and are therefore run together.
struct VelocityGroup {
  std::string_view name;
  Hull hull = Hull::symmetric;
  double current_mps = 0, current_towards_deg = 0;
  bool gaps = false, log_errors = false;
  std::vector<VelocityCase> cases;
};

const std::vector<VelocityGroup>& velocity_groups();

struct MethodName {
  Method method;
  std::string_view name;
};
inline constexpr std::array velocity_methods{
    MethodName{Method::pure, "pure"}, MethodName{Method::earlier, "earlier"},
    MethodName{Method::paper, "paper"}, MethodName{Method::ours, "ours"}};

/// The bounds that hold 95 % of the mean NEES of this number of runs, if the filter is consistent.
/// They apply to one instant. The mean over time varies at most as much, because the errors of a
/// run are similar at all times.
struct Band {
  double low, high;
};
Band nees_band(std::size_t runs);

/// One method in one case, over the runs.
class VelocityStatistics {
 public:
  explicit VelocityStatistics(std::size_t instants);

  void add(const VelocityTrial& trial);

  std::size_t runs() const { return north_.runs(); }
  std::size_t instants() const { return north_.instants(); }
  double horizontal_rmse(std::size_t instant) const;  ///< m
  double horizontal_rmse_max() const;
  double horizontal_rmse_end() const { return horizontal_rmse(instants() - 1); }
  double growth_rmse_end() const;              ///< m; growth since the initial error
  double worst_run() const { return worst_; }  ///< m, at the end
  Eigen::Vector3d velocity_rmse() const;       ///< over time and runs, m/s
  Eigen::Vector3d velocity_mean() const;
  double stated_sigma_end() const;  ///< m; RMS of the position sigma that the method states
  double nees_mean() const;         ///< horizontal position, over time and runs
  double growth_nees_mean() const;  ///< growth since the initial error

  const Ensemble& north() const { return north_; }
  const Ensemble& east() const { return east_; }
  const Ensemble& up() const { return up_; }
  const Ensemble& velocity(std::size_t axis) const { return velocity_[axis]; }

 private:
  Ensemble north_, east_, up_, growth_north_, growth_east_, stated_, nees_, growth_nees_;
  std::array<Ensemble, 3> velocity_;
  Eigen::Vector3d velocity_square_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_sum_ = Eigen::Vector3d::Zero();
  double worst_ = 0;
};

/// A case's methods in the order of velocity_methods; empty: no run was finished.
struct CaseResult {
  VelocityCase which;
  std::vector<VelocityStatistics> methods;
};

/// The error of `ours` in case 2 with only one source of error.
struct BudgetLine {
  std::string_view source;
  double rmse_end_m;
};

struct VelocityResults {
  std::vector<CaseResult> cases;
  std::vector<BudgetLine> budget;
  std::size_t budget_runs = 0;
  std::vector<MissionInstant> track;  ///< the truth of case 1, once a minute
};

}  // namespace drydock::study
