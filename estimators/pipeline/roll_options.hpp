#pragma once

#include "estimators/pipeline/maker.hpp"
#include "estimators/roll/hypothesis.hpp"

namespace drydock::pipeline {

/// The roll filter on the roll gyro of one IMU and one satellite receiver.
struct RollOptions {
  std::optional<std::uint16_t> gnss;  ///< device index; needed
  roll::AllSatellitesOptions filter;  ///< the next two give antenna.tracking_limit
  double boresight_cno_dbhz = 48;     ///< C/N0 of a satellite on the boresight of the antenna
  double lowest_cno_dbhz = 20;        ///< the lowest C/N0 that the receiver reports
  double axis_sigma_rad = 0.01;       ///< between body x and the velocity: angle of attack
  double least_speed_mps = 20;        ///< below it the velocity does not give the axis
};

std::string fault_of(const RollOptions& options);
std::unique_ptr<Estimator> make_estimator(Seat seat, const RollOptions& options,
                                          const PipelineOptions& pipeline);

}  // namespace drydock::pipeline
