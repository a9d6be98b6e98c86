#include <limits>
#include <stdexcept>

#include "drivers/host/rig_recorder.hpp"
#include "hil/track/formats.hpp"

namespace drydock::track {
namespace {

/// The rig with two navigators in the place of its estimators: the recorder names topics by them.
rig_config::Rig rig_of_track(const Outcome& outcome) {
  rig_config::Rig rig = outcome.gathered.rig;
  rig.estimators.clear();
  for (const char* name : {"smoothed", "filtered"})
    rig.estimators.push_back({name, "", rig_config::NavigationConfig{}});
  return rig;
}

host::Estimate estimate_of(const Outcome& outcome, const smoothing::TrackPoint& point,
                           std::size_t estimator) {
  host::Estimate estimate;
  estimate.estimator = estimator;
  auto& n = estimate.navigation.emplace();
  n.valid_at = outcome.gathered.utc + measurement::from_seconds(point.time_s);
  n.latitude_rad = point.position.latitude_rad;
  n.longitude_rad = point.position.longitude_rad;
  n.height_m =
      outcome.has_heights ? point.position.height_m : std::numeric_limits<double>::quiet_NaN();
  n.offset_ned = frame::ned_offset(outcome.track.smoothed.front().position, point.position);
  n.velocity_ned = point.velocity_ned;
  n.body_to_ned = frame::body_to_ned(point.attitude);
  n.covariance.topLeftCorner<3, 3>() = point.position_covariance;
  n.covariance.block<3, 3>(3, 3) = point.velocity_covariance;
  n.covariance(8, 8) = point.heading_sigma_rad * point.heading_sigma_rad;
  estimate.attitude.valid_at = n.valid_at;
  estimate.attitude.roll_rad = point.attitude.roll;
  estimate.attitude.pitch_rad = point.attitude.pitch;
  estimate.attitude.yaw_rad = point.attitude.yaw;
  return estimate;
}

}  // namespace

void write_mcap(const Outcome& outcome, const std::string& path, bool overwrite) {
  host::RecordOptions options;
  options.path = path;
  options.overwrite = overwrite;
  const auto rig = rig_of_track(outcome);
  host::RigRecorder recorder(rig, options, outcome.gathered.utc, record::WhenBehind::wait);
  for (std::size_t k = 0; k < outcome.track.smoothed.size(); ++k) {
    recorder.on_estimate(estimate_of(outcome, outcome.track.smoothed[k], 0));
    recorder.on_estimate(estimate_of(outcome, outcome.track.filtered[k], 1));
  }
  const auto line = recorder.finish();
  if (recorder.failed()) throw std::runtime_error(line);
}

}  // namespace drydock::track
