#pragma once

#include <Eigen/Core>
#include <string_view>

#include "hil/sensor/random.hpp"
#include "rig_config/rig.hpp"

namespace drydock::sensor {

/// Error of one quantity of a device: a constant bias and white noise per axis. Quantisation is
/// the wire's. The bias is +1 sigma as given, or drawn once from N(0, 1 sigma).
class ErrorModel {
 public:
  ErrorModel(const rig_config::SensorErrors& sigma, bool fixed_bias, std::uint64_t seed,
             std::string_view device, std::string_view quantity);

  Eigen::Vector3d apply(const Eigen::Vector3d& ideal);
  double apply(double ideal);  ///< of a scalar quantity: the first axis

  const Eigen::Vector3d& bias() const { return bias_; }

 private:
  Eigen::Vector3d noise_sigma_;
  Eigen::Vector3d bias_;
  RandomStream noise_;
};

}  // namespace drydock::sensor
