#pragma once

#include <cmath>

#include "estimators/frame/attitude.hpp"
#include "estimators/pipeline/pipeline.hpp"
#include "estimators/pipeline/roll_estimator.hpp"
#include "tests/estimators/pipeline/support.hpp"
#include "tests/estimators/roll/flight.hpp"

/// A rolling airframe for tests of its estimator.
namespace drydock::pipeline::test {

inline constexpr std::uint16_t gnss_device = 7;
inline constexpr double boresight_dbhz = 48;

inline PipelineOptions rolling(std::chrono::milliseconds window = {}) {
  PipelineOptions options;
  EstimatorOptions& estimator = options.estimators.emplace_back();
  estimator.name = "roll";
  estimator.imu = imu_device;
  estimator.kind.emplace<RollOptions>().gnss = gnss_device;
  options.reorder_window = window;
  return options;
}

/// A steady roll under eight satellites. The receiver rounds to whole dB.
struct Rocket {
  roll::test::Flight flight;
  double speed_mps = 300;

  measurement::ImuSample imu(std::int64_t ms) const {
    measurement::ImuSample sample = test::imu(ms);
    sample.angular_rate = {flight.rate_radps, 0, 0};
    return sample;
  }
  measurement::GnssFix fix(std::int64_t ms) const {
    measurement::GnssFix fix;
    fix.origin.valid_at = at_ms(ms);
    fix.origin.device = gnss_device;
    const double along = speed_mps * std::cos(flight.pitch);
    fix.velocity_ned =
        Eigen::Vector3d{along * std::cos(flight.azimuth), along * std::sin(flight.azimuth),
                        -speed_mps * std::sin(flight.pitch)};
    return fix;
  }
  measurement::GnssSatellites sky(std::int64_t ms) {
    measurement::GnssSatellites sky;
    sky.origin.valid_at = at_ms(ms);
    sky.origin.device = gnss_device;
    for (const auto& signal : flight.at(0.001 * static_cast<double>(ms))) {
      const auto& way = roll::test::directions[signal.satellite];
      measurement::Satellite satellite;
      satellite.number = static_cast<std::uint8_t>(signal.satellite + 1);
      satellite.elevation_rad = way[0] * roll::test::degree;
      satellite.azimuth_rad = way[1] * roll::test::degree;
      const double cno =
          std::round(boresight_dbhz + 10 * std::log10(std::max(*signal.power, 1e-9)));
      if (cno >= 20) satellite.cno_dbhz = cno;
      sky.satellites.push_back(satellite);
    }
    return sky;
  }
  double roll_deg(std::int64_t ms) const {
    return frame::wrap_pi(flight.roll(0.001 * static_cast<double>(ms))) / roll::test::degree;
  }
};

}  // namespace drydock::pipeline::test
