#pragma once

#include <array>
#include <boost/container/static_vector.hpp>

#include "drivers/measurement/units.hpp"
#include "estimators/roll/peak_finder.hpp"

namespace drydock::roll {

/// All sigmas are one standard deviation.
struct PeakFilterOptions {
  AntennaOptions antenna;
  PeakOptions peak;
  bool with_bias = false;  ///< the gyro's bias as a second state
  double peak_sigma_rad = 10 * units::degree;
  double roll_noise = units::degree;                  ///< w of eq. (21), rad per sqrt(s)
  double bias_noise = 1e-4 * std::numbers::pi / 180;  ///< rad/s per sqrt(s)
  double bias_sigma_radps = units::degree;            ///< at the start
};

/// The filter of the paper: the gyro predicts the roll, eq. (21), and peaks correct it, eq. (22). A
/// bias state is optional. The first peak starts the filter. Allocates nothing, throws nothing;
/// inputs must be finite.
class PeakFilter {
 public:
  explicit PeakFilter(const PeakFilterOptions& options) : options_(options) {}

  void predict(double rate_radps, double dt);
  void update(const Epoch& epoch);

  bool running() const { return running_; }
  double roll() const;  ///< (-pi, pi]
  double roll_variance() const { return p_(0, 0); }
  double bias() const { return x_(1); }

  /// The peaks of the last epoch. Their times and angles are those of `time_s()` and `gyro_rad()`.
  std::span<const Peak> peaks() const { return {peaks_.data(), peaks_.size()}; }
  double time_s() const { return time_s_; }
  double gyro_rad() const { return gyro_rad_; }

 private:
  void use(const Peak& peak);

  PeakFilterOptions options_;
  double time_s_ = 0, gyro_rad_ = 0;
  SatelliteSlots slots_;
  std::array<PeakFinder, most_satellites> finders_{};
  boost::container::static_vector<Peak, most_satellites> peaks_;
  bool running_ = false;
  Eigen::Vector2d x_ = Eigen::Vector2d::Zero();  ///< roll, gyro bias
  Eigen::Matrix2d p_ = Eigen::Matrix2d::Zero();
};

}  // namespace drydock::roll
