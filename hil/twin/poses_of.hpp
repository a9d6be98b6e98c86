#pragma once

#include "estimators/smoothing/track.hpp"
#include "hil/motion/splined/pose.hpp"

namespace drydock::twin {

/// The track at equal steps of about `every_s`, first and last point included. Position: a cubic
/// through the neighbours with their velocities; attitude: the mean of the points within half a
/// step, which takes out the noise of tilt sensors. Throws std::runtime_error for a track that is
/// shorter than two steps.
motion::Poses poses_of(const std::vector<smoothing::TrackPoint>& track, double every_s);

}  // namespace drydock::twin
