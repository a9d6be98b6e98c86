#include "hil/emulate/dvl/dvl_head.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drydock::emulate {

wire::DvlAttitude head_attitude(const measurement::BottomVelocity& measured) {
  const double heading = *measured.heading_rad;
  return {heading < 0 ? heading + 2 * std::numbers::pi : heading,
          std::atan(std::tan(*measured.pitch_rad) / std::cos(*measured.roll_rad)),
          measured.roll_rad};
}

wire::DvlComponents along_head_axes(const Eigen::Vector3d& frd, std::optional<double> error_mps) {
  return {frd.y(), frd.x(), -frd.z(), error_mps};
}

std::uint8_t correlation_counts(double snr_db) {
  const double ratio = std::pow(10, snr_db / 10);
  return static_cast<std::uint8_t>(std::lround(255 * ratio / (1 + ratio)));
}

std::uint8_t amplitude_counts(double snr_db) {
  constexpr double noise_counts = 40, db_per_count = 0.61;
  return static_cast<std::uint8_t>(std::clamp(noise_counts + snr_db / db_per_count, 0.0, 255.0));
}

}  // namespace drydock::emulate
