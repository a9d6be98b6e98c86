#include "hil/sensor/errors.hpp"

#include <string>

namespace drydock::sensor {
namespace {

Eigen::Vector3d vector(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

}  // namespace

ErrorModel::ErrorModel(const rig_config::SensorErrors& sigma, bool fixed_bias, std::uint64_t seed,
                       std::string_view device, std::string_view quantity)
    : noise_sigma_(vector(sigma.noise)),
      bias_(vector(sigma.bias)),
      noise_(seed, device, std::string(quantity) + " noise") {
  if (fixed_bias) return;
  RandomStream draw(seed, device, std::string(quantity) + " bias");
  bias_ = bias_.cwiseProduct(draw.normal3());
}

Eigen::Vector3d ErrorModel::apply(const Eigen::Vector3d& ideal) {
  return ideal + bias_ + noise_sigma_.cwiseProduct(noise_.normal3());
}

double ErrorModel::apply(double ideal) {
  return ideal + bias_.x() + noise_sigma_.x() * noise_.normal();
}

}  // namespace drydock::sensor
