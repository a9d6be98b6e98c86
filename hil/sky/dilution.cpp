#include "hil/sky/dilution.hpp"

#include <Eigen/LU>
#include <cmath>

namespace drydock::sky {

namespace {

/// Above this the position error is hundreds of metres and counts as no solution.
constexpr double largest_geometric = 100;

Eigen::Vector4d row_of(double elevation, double azimuth) {
  return {-std::cos(elevation) * std::cos(azimuth), -std::cos(elevation) * std::sin(azimuth),
          std::sin(elevation), 1};
}

}  // namespace

std::optional<Dilution> dilution(std::span<const measurement::Satellite> satellites) {
  Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
  for (const auto& s : satellites) {
    if (!s.used || !s.elevation_rad || !s.azimuth_rad) continue;
    const Eigen::Vector4d row = row_of(*s.elevation_rad, *s.azimuth_rad);
    information += row * row.transpose();
  }
  const Eigen::Vector4d q = information.inverse().diagonal();
  if (!q.allFinite() || !(q.array() > 0).all() || q.sum() > largest_geometric * largest_geometric)
    return {};
  return Dilution{std::sqrt(q.sum()), std::sqrt(q.head<3>().sum()), std::sqrt(q.head<2>().sum()),
                  std::sqrt(q[2]), std::sqrt(q[3])};
}

}  // namespace drydock::sky
