#pragma once

#include <cmath>
#include <optional>

#include "drivers/measurement/measurement.hpp"

namespace drydock::measurement {

/// Euler's roll and pitch of a DVL's head, rad.
struct HeadTilt {
  double roll_rad = 0, pitch_rad = 0;
};

/// The pitch sensor of a head reads the tilt of its bow axis, which is more than Euler's pitch
/// while the head is heeled: docs/sensors/protocols/pd0.md. Empty: the head does not tell both
/// angles.
inline std::optional<HeadTilt> head_tilt(const BottomVelocity& track) {
  if (!track.roll_rad || !track.pitch_rad) return {};
  const HeadTilt tilt{*track.roll_rad,
                      std::atan(std::tan(*track.pitch_rad) * std::cos(*track.roll_rad))};
  if (!std::isfinite(tilt.roll_rad) || !std::isfinite(tilt.pitch_rad)) return {};
  return tilt;
}

}  // namespace drydock::measurement
