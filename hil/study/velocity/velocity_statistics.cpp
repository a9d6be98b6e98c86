#include "hil/study/velocity/velocity_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::study {

const std::vector<VelocityGroup>& velocity_groups() {
  static const std::vector<VelocityGroup> groups{
      {.name = "cases 1 and 2",
       .cases = {{"case1", 0, "exact coefficients"}, {"case2", 0.1, "coefficients 10 %"}}},
      {.name = "case 2 at 20 %", .cases = {{"case2_20", 0.2, "coefficients 20 %"}}},
      {.name = "eml", .log_errors = true, .cases = {{"eml", 0.1, "log scale 0.5 %, bias 5 mm/s"}}},
      {.name = "asymmetric",
       .hull = Hull::asymmetric,
       .cases = {{"asymmetric", 0.1, "hull with starred coefficients"}}},
      {.name = "current along",
       .current_mps = 0.3,
       .current_towards_deg = 45,
       .cases = {{"current", 0.1, "0.3 m/s with the course"}}},
      {.name = "current across",
       .current_mps = 0.3,
       .current_towards_deg = 135,
       .cases = {{"current_across", 0.1, "0.3 m/s across"}}},
      {.name = "dvl gaps",
       .gaps = true,
       .cases = {{"dvl_gaps", 0.1, "DVL on and off every 10 min"}}},
      {.name = "all",
       .hull = Hull::asymmetric,
       .current_mps = 0.3,
       .current_towards_deg = 45,
       .log_errors = true,
       .cases = {{"all", 0.1, "eml, asymmetric, current along"}}},
  };
  return groups;
}

Band nees_band(std::size_t runs) {
  // Chi-square with two states per run, by Wilson and Hilferty: accurate to 1e-3 from ten runs on.
  const double freedom = 2 * static_cast<double>(runs), spread = 2 / (9 * freedom);
  const auto bound = [&](double sigma) {
    return std::pow(1 - spread + sigma * std::sqrt(spread), 3);
  };
  return {bound(-1.959964), bound(1.959964)};
}

namespace {

double mean_over_time(const Ensemble& values) {
  double sum = 0;
  for (std::size_t i = 0; i < values.instants(); ++i) sum += values.mean(i);
  return sum / static_cast<double>(values.instants());
}

}  // namespace

VelocityStatistics::VelocityStatistics(std::size_t instants)
    : north_(instants),
      east_(instants),
      up_(instants),
      growth_north_(instants),
      growth_east_(instants),
      stated_(instants),
      nees_(instants),
      growth_nees_(instants - 1),
      velocity_{Ensemble(instants), Ensemble(instants), Ensemble(instants)} {}

void VelocityStatistics::add(const VelocityTrial& trial) {
  const auto grown = [](std::vector<double> error) {
    const double first = error.front();
    for (double& e : error) e -= first;
    return error;
  };
  north_.add(trial.north_m);
  east_.add(trial.east_m);
  up_.add(trial.up_m);
  growth_north_.add(grown(trial.north_m));
  growth_east_.add(grown(trial.east_m));
  stated_.add(trial.stated_m2);
  nees_.add(trial.nees);
  growth_nees_.add(trial.growth_nees);
  for (std::size_t axis = 0; axis < 3; ++axis) velocity_[axis].add(trial.mps[axis]);
  velocity_square_ += trial.velocity_square;
  velocity_sum_ += trial.velocity_mean;
  worst_ = std::max(worst_, std::hypot(trial.north_m.back(), trial.east_m.back()));
}

double VelocityStatistics::horizontal_rmse(std::size_t instant) const {
  return std::hypot(north_.rms(instant), east_.rms(instant));
}

double VelocityStatistics::horizontal_rmse_max() const {
  double largest = 0;
  for (std::size_t i = 0; i < instants(); ++i) largest = std::max(largest, horizontal_rmse(i));
  return largest;
}

double VelocityStatistics::growth_rmse_end() const {
  return std::hypot(growth_north_.rms(instants() - 1), growth_east_.rms(instants() - 1));
}

Eigen::Vector3d VelocityStatistics::velocity_rmse() const {
  return (velocity_square_ / static_cast<double>(runs())).cwiseSqrt();
}

Eigen::Vector3d VelocityStatistics::velocity_mean() const {
  return velocity_sum_ / static_cast<double>(runs());
}

double VelocityStatistics::stated_sigma_end() const {
  return std::sqrt(stated_.mean(instants() - 1));
}

double VelocityStatistics::nees_mean() const { return mean_over_time(nees_); }

double VelocityStatistics::growth_nees_mean() const { return mean_over_time(growth_nees_); }

}  // namespace drydock::study
