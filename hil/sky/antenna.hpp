#pragma once

#include <Eigen/Core>

/// The receiving antenna of the GPS roll paper (Hong et al. 2015), modelled there after a NovAtel
/// ANT-532: the gain depends on the angle from boresight alone.
namespace drydock::sky {

/// Eq. (24): elevation above the antenna's own horizon, rad; pi/2 is boresight. Both are unit
/// vectors in body axes; the paper has the boresight on +z.
double antenna_elevation(const Eigen::Vector3d& toward_body, const Eigen::Vector3d& boresight_body);

/// Eq. (23), corrected and relative to boresight: exp(-((90 deg - elevation) / 64.58 deg)^2). The
/// paper's P is 664 times this. -8.4 dB on the antenna's horizon, -33.7 dB behind it.
double antenna_power(double elevation_rad);

}  // namespace drydock::sky
