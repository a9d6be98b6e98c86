#include "hil/twin/surroundings.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "hil/sensor/ideal.hpp"

namespace drydock::twin {
namespace {

constexpr double least_water_m = 1;  ///< between the deepest point of the track and the bed

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

struct Sounding {
  double t_s = 0, bed_m = 0;  ///< since the track's start; depth of the bed below the surface
};

std::vector<Sounding> soundings_of(const ByDevice& measured, const rig_config::Rig& rig,
                                   const motion::Trajectory& track) {
  std::vector<Sounding> all;
  for (std::size_t i = 0; i < std::min(measured.size(), rig.devices.size()); ++i) {
    const auto mounting = sensor::mounting_of(rig.devices[i]);
    for (const auto& m : measured[i]) {
      const auto* dvl = std::get_if<measurement::BottomVelocity>(&m);
      if (dvl == nullptr || !dvl->altitude_m) continue;
      const auto at = dvl->origin.valid_at;
      all.push_back({measurement::seconds(at - track.start()),
                     sensor::depth_at(track.at(at), mounting) + *dvl->altitude_m});
    }
  }
  return all;
}

constexpr double half_window_s = 120;

/// On a line between the neighbours; beyond the ends the first or the last.
double bed_at(const std::vector<Sounding>& means, double t) {
  const auto next = std::ranges::lower_bound(means, t, {}, &Sounding::t_s);
  if (next == means.begin()) return means.front().bed_m;
  if (next == means.end()) return means.back().bed_m;
  const auto& before = *std::prev(next);
  return std::lerp(before.bed_m, next->bed_m, (t - before.t_s) / (next->t_s - before.t_s));
}

/// Least squares over log speeds: what the log says ahead is the track's velocity less the current,
/// along the vehicle's bow, and a bias of the log. The current is told if the bow turned enough.
class CurrentFit {
 public:
  void add(double ahead_mps, const motion::Truth& truth) {
    const Eigen::Vector3d bow = truth.body_to_ned * Eigen::Vector3d::UnitX();
    const Eigen::Vector3d row{bow.x(), bow.y(), -1};
    normal_ += row * row.transpose();
    right_ += row * (truth.velocity_body.x() - ahead_mps);
    ++count_;
  }
  std::optional<Eigen::Vector2d> current() const {
    constexpr double least_share = 0.01;  ///< of the smallest eigenvalue; a full circle has 0.25
    if (count_ < 10) return {};
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(normal_, Eigen::EigenvaluesOnly);
    if (eigen.eigenvalues().minCoeff() < least_share * normal_.trace()) return {};
    return Eigen::Vector2d((normal_.inverse() * right_).head<2>());
  }

 private:
  Eigen::Matrix3d normal_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_ = Eigen::Vector3d::Zero();
  std::size_t count_ = 0;
};

}  // namespace

std::vector<double> bed_along(const ByDevice& measured, const rig_config::Rig& rig,
                              const motion::Trajectory& track, std::span<const double> times_s) {
  auto soundings = soundings_of(measured, rig, track);
  std::ranges::stable_sort(soundings, {}, &Sounding::t_s);
  std::vector<Sounding> means;
  for (const double t : times_s) {
    const auto from = std::ranges::lower_bound(soundings, t - half_window_s, {}, &Sounding::t_s);
    double weights = 0, sum = 0;
    for (auto one = from; one != soundings.end() && one->t_s < t + half_window_s; ++one) {
      const double weight = half_window_s - std::abs(one->t_s - t);
      weights += weight;
      sum += weight * one->bed_m;
    }
    if (weights > 0) means.push_back({t, sum / weights});
  }
  if (means.empty()) return {};
  std::vector<double> beds;
  for (const double t : times_s) beds.push_back(bed_at(means, t));
  return beds;
}

Surroundings surroundings_of(const ByDevice& measured, const rig_config::Rig& rig,
                             const motion::Trajectory& track) {
  CurrentFit current;
  for (const auto& of_device : measured)
    for (const auto& m : of_device)
      if (const auto* log = std::get_if<measurement::WaterSpeed>(&m);
          log != nullptr && log->longitudinal_mps)
        current.add(*log->longitudinal_mps, track.at(log->origin.valid_at));
  Surroundings found;
  found.current_ne_mps = current.current();
  std::vector<double> beds;
  for (const auto& one : soundings_of(measured, rig, track)) beds.push_back(one.bed_m);
  if (beds.empty()) return found;
  found.bed_depth_m = median(beds);
  for (double& bed : beds) bed = std::abs(bed - *found.bed_depth_m);
  found.bed_scatter_m = median(beds);
  return found;
}

rig_config::OceanConfig ocean_of(const Surroundings& surroundings, double deepest_m) {
  rig_config::OceanConfig ocean;
  ocean.bed.depth_m =
      std::max(surroundings.bed_depth_m.value_or(ocean.bed.depth_m), deepest_m + least_water_m);
  if (surroundings.current_ne_mps) {
    const auto& current = *surroundings.current_ne_mps;
    ocean.current.push_back({0, {current.x(), current.y(), 0}});
  }
  return ocean;
}

}  // namespace drydock::twin
