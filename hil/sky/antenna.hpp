#pragma once

#include <Eigen/Core>

/// The receiving antenna of the GPS roll paper (Hong et al. 2015), which models a NovAtel ANT-532:
/// the gain depends only on the angle from boresight.
namespace drydock::sky {

/// Eq. (24): elevation above the antenna's own horizon, rad; pi/2 is boresight. Both arguments are
/// unit vectors in body axes. In the paper the boresight is +z.
double antenna_elevation(const Eigen::Vector3d& toward_body, const Eigen::Vector3d& boresight_body);

/// Eq. (23), corrected and relative to boresight: exp(-((90 deg - elevation) / 64.58 deg)^2). The
/// paper's P is 664 times this. -8.4 dB at the antenna's horizon, -33.7 dB opposite to boresight.
double antenna_power(double elevation_rad);

}  // namespace drydock::sky
