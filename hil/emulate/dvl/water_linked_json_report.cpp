#include "hil/emulate/dvl/water_linked_json_report.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "hil/emulate/dvl/a50.hpp"

namespace drydock::emulate {
namespace {

using wire::water_linked_json::Transducer;
using wire::water_linked_json::VelocityReport;
using Directions = std::array<Eigen::Vector3d, 4>;

/// A beam's velocity is never better than this: the lines of real units say a few mm/s.
constexpr double least_noise_mps = 0.0017;
/// What the serial protocol's documents show without a velocity.
constexpr double merit_without_velocity_mps = 2.707;

/// sigma2 (D' D)^-1, where the rows of D are the directions of the beams that echo.
Eigen::Matrix3d covariance_of_beams(const PingReport& of, const Directions& directions,
                                    double beam_noise_mps) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < directions.size(); ++i)
    if (of.beams[i].range_m) normal += directions[i] * directions[i].transpose();
  const double sigma = std::max(beam_noise_mps, least_noise_mps);
  return sigma * sigma * normal.inverse();
}

void set_accuracy(const Eigen::Matrix3d& covariance, VelocityReport& report) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> of(covariance, Eigen::EigenvaluesOnly);
  report.figure_of_merit_mps = std::sqrt(of.eigenvalues().maxCoeff());
  for (std::size_t i = 0; i < report.covariance.size(); ++i)
    report.covariance[i] =
        covariance(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3));
}

Transducer transducer_of(const sensor::DvlPing::Beam& echo, std::size_t beam,
                         double error_along_it) {
  Transducer transducer;
  transducer.id = a50::transducers_of_beams[beam];
  transducer.valid = echo.range_m.has_value();
  transducer.distance_m = echo.range_m;
  if (echo.velocity_mps) transducer.velocity_mps = *echo.velocity_mps + error_along_it;
  transducer.noise_dbm = a50::noise_dbm;
  transducer.rssi_dbm = a50::noise_dbm + echo.snr_db;
  return transducer;
}

}  // namespace

sensor::JanusHead head_with_a50s_beams() {
  sensor::JanusHead head = a50::head_of_an_a50;
  head.turn_rad = 45 * units::degree;
  return head;
}

VelocityReport json_report(const PingReport& of, const sensor::JanusHead& head) {
  const Directions directions = sensor::beam_directions(head);
  VelocityReport report;
  for (std::size_t beam = 0; beam < directions.size(); ++beam) {
    const auto id = static_cast<std::size_t>(a50::transducers_of_beams[beam]);
    report.transducers[id] = transducer_of(of.beams[beam], beam, directions[beam].dot(of.error));
  }
  report.valid = of.velocity.has_value();
  report.figure_of_merit_mps = merit_without_velocity_mps;
  if (!of.velocity) return report;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(of.turned_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Vector3d v = turn * *of.velocity;
  report.velocity_mps = {v.x(), v.y(), v.z()};
  const Eigen::Matrix3d covariance = covariance_of_beams(of, directions, head.beam_noise_mps);
  set_accuracy(turn * covariance * turn.transpose(), report);
  return report;
}

}  // namespace drydock::emulate
