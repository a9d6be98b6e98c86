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
  double coefficient_sigma;  ///< of the vehicle as the methods know it, relative
  std::string_view what;     ///< in a few words
};

/// Cases that share truth and sensors, and so are run together.
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

/// 95 % of the mean NEES of so many runs lie between, if the filter is consistent: of one instant,
/// and so, errors of a run being alike at all times, of their mean over time at most.
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
  double growth_rmse_end() const;              ///< m: what has been added to the initial error
  double worst_run() const { return worst_; }  ///< m, at the end
  Eigen::Vector3d velocity_rmse() const;       ///< over time and runs, m/s
  Eigen::Vector3d velocity_mean() const;
  double stated_sigma_end() const;  ///< m: of the position as the method itself states it, RMS
  double nees_mean() const;         ///< of the horizontal position, over time and runs
  double growth_nees_mean() const;  ///< of what was added to the initial error

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

/// A case's methods in the order of velocity_methods; empty: no run was done.
struct CaseResult {
  VelocityCase which;
  std::vector<VelocityStatistics> methods;
};

/// What is left of `ours` in case 2 when one source of error is alone.
struct BudgetLine {
  std::string_view source;
  double rmse_end_m;
};

struct VelocityResults {
  std::vector<CaseResult> cases;
  std::vector<BudgetLine> budget;
  std::size_t budget_runs = 0;
  std::vector<MissionInstant> track;  ///< of case 1's truth, once a minute
};

}  // namespace drydock::study
