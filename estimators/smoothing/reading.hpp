#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

/// What a smoother reads: all that was measured on a dive, in the order of its times.
namespace drydock::smoothing {

enum class Quantity : std::uint8_t { bottom, log, depth, heading, fix };

/// One measured value. An axis that is NaN was not measured.
///   bottom   velocity over ground of the sensor, body axes, m/s
///   log      speed through the water, body x and y, m/s
///   depth    of the sensor, m, in x
///   heading  true heading of body x, rad, in x
///   fix      latitude rad, longitude rad, height m of the antenna above the ellipsoid; sigma in m
///            north, east, up
struct Reading {
  double time_s = 0;  ///< since the begin of the dive
  Quantity quantity = Quantity::bottom;
  std::uint16_t device = 0;
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  Eigen::Vector3d sigma = Eigen::Vector3d::Ones();
};

/// Roll and pitch of the body at one time, and their rates.
struct Tilt {
  double time_s = 0, roll_rad = 0, pitch_rad = 0;
  double roll_radps = 0, pitch_radps = 0;  ///< smooth_tilts() finds them
};

/// An IMU sample in body axes: rad/s and m/s2.
struct InertialReading {
  double time_s = 0;
  Eigen::Vector3d rate = Eigen::Vector3d::Zero(), force = Eigen::Vector3d::Zero();
};

struct Dive {
  std::vector<Reading> readings;  ///< times do not decrease
  std::vector<Tilt> tilts;        ///< likewise; empty: the vehicle is taken as level
  std::vector<InertialReading> inertial;
};

/// The tilt at a time: between its neighbours on the cubic with their rates, or on a line if they
/// are far from each other; beyond the ends the nearest one.
Tilt tilt_at(const std::vector<Tilt>& tilts, double time_s);

/// A measured value minus the expected one, and the standard deviation that the filter expects of
/// this difference.
struct Residual {
  double value = 0, sigma = 0;
  bool known = false;  ///< the axis was measured and compared
  bool used = false;   ///< and it was inside the gate

  double normalised() const { return value / sigma; }
};

/// Three residuals for each reading of a dive, in the order of the readings.
using Residuals = std::vector<std::array<Residual, 3>>;

}  // namespace drydock::smoothing
