#include "tests/estimators/smoothing/dive_of.hpp"

#include <cmath>

#include "estimators/frame/earth.hpp"

namespace drydock::smoothing::test {

using Eigen::Vector3d;

std::vector<Voyage::Place> Voyage::each_second(std::uint64_t seed) const {
  constexpr int a_second = 20;
  constexpr double dt = 1.0 / a_second;
  std::mt19937_64 random(seed + 1'000'000);
  std::normal_distribution<double> unit;
  const auto wander = [&](double& value, double sigma, double tau) {
    value += -value * dt / tau + sigma * std::sqrt(2 * dt / tau) * unit(random);
  };
  std::vector<Place> places;
  Place p;
  p.heading = 0.3;
  Vector3d level = Vector3d::Zero();
  for (int k = 0; k <= duration_s() * a_second; ++k) {
    const double under = k * dt - 60;
    const bool dives = under > 0 && under < under_s_;
    const double phase = 2 * M_PI * under / under_s_;
    p.depth = dives ? 20 * (1 - std::cos(phase)) : 0;
    const double sink = dives ? 20 * 2 * M_PI / under_s_ * std::sin(phase) : 0;
    wander(level.x(), 0.1, 100);
    wander(level.y(), 0.1, 100);
    wander(p.turn, 0.02, 60);
    p.velocity_level = {1.5 + level.x(), level.y(), sink};
    p.pitch = -std::atan2(sink, 1.5);
    if (k % a_second == 0) places.push_back(p);
    const double heading = p.heading + p.turn * dt / 2;
    p.north +=
        dt * (std::cos(heading) * p.velocity_level.x() - std::sin(heading) * p.velocity_level.y());
    p.east +=
        dt * (std::sin(heading) * p.velocity_level.x() + std::cos(heading) * p.velocity_level.y());
    p.heading += p.turn * dt;
  }
  return places;
}

namespace {

Vector3d in_body(const Vector3d& level, double pitch) {
  const double s = std::sin(pitch), c = std::cos(pitch);
  return {c * level.x() - s * level.z(), level.y(), s * level.x() + c * level.z()};
}

}  // namespace

Drawn drawn(const Voyage& voyage, std::uint64_t seed, double current_sigma) {
  constexpr double velocity_sigma = 0.01, heading_sigma = 0.5 * M_PI / 180, depth_sigma = 0.1;
  constexpr double fix_sigma = 1.5, bias_sigma = 1.0 * M_PI / 180;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> unit;
  const auto normal = [&](double sigma) { return sigma * unit(random); };
  Drawn out{{}, voyage.each_second(seed)};
  const double bias = normal(bias_sigma);
  const Eigen::Vector2d current{normal(current_sigma), normal(current_sigma)};
  auto& readings = out.dive.readings;
  const double meridian = frame::meridian_radius(origin.latitude_rad);
  const double parallel =
      frame::transverse_radius(origin.latitude_rad) * std::cos(origin.latitude_rad);
  for (std::size_t k = 0; k < out.truth.size(); ++k) {
    const auto t = static_cast<double>(k);
    const auto& p = out.truth[k];
    out.dive.tilts.push_back({t, 0, p.pitch});
    Vector3d velocity = p.velocity_level;
    const double s = std::sin(p.heading), c = std::cos(p.heading);
    if (current_sigma > 0)
      velocity -=
          Vector3d{c * current.x() + s * current.y(), -s * current.x() + c * current.y(), 0};
    const Vector3d noise{normal(velocity_sigma), normal(velocity_sigma), normal(velocity_sigma)};
    readings.push_back({t, current_sigma > 0 ? Quantity::log : Quantity::bottom, 0,
                        in_body(velocity, p.pitch) + noise, Vector3d::Constant(velocity_sigma)});
    readings.push_back({t,
                        Quantity::heading,
                        1,
                        {p.heading + bias + normal(heading_sigma), 0, 0},
                        Vector3d::Constant(heading_sigma)});
    readings.push_back({t,
                        Quantity::depth,
                        2,
                        {p.depth + normal(depth_sigma), 0, 0},
                        Vector3d::Constant(depth_sigma)});
    if (voyage.at_surface(t))
      readings.push_back({t,
                          Quantity::fix,
                          3,
                          {origin.latitude_rad + (p.north + normal(fix_sigma)) / meridian,
                           origin.longitude_rad + (p.east + normal(fix_sigma)) / parallel, 0},
                          Vector3d::Constant(fix_sigma)});
  }
  return out;
}

LevelOptions options_of(const Drawn& drawn) {
  LevelOptions options;
  options.start = level_start(drawn.dive, origin);
  options.sigmas.heading_bias_rad = 1.0 * M_PI / 180;
  options.motion.velocity_mps = 0.05;
  options.motion.current_mps = 0;
  return options;
}

Eigen::Vector2d offset(const frame::Position& position) {
  return frame::ned_offset(origin, position).head<2>();
}

}  // namespace drydock::smoothing::test
