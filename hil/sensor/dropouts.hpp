#pragma once

#include "hil/sensor/random.hpp"
#include "rig_config/emulate.hpp"

namespace drydock::sensor {

/// Decides which samples are lost (docs/sensors/errors.md (15)): outages of geometric length, a
/// Gilbert channel.
class Dropouts {
 public:
  Dropouts(const rig_config::DropoutConfig& config, std::uint64_t seed, std::string_view device);

  bool next_is_lost();

 private:
  double begin_, last_;  ///< probabilities that an outage begins and that it continues
  bool out_ = false;
  RandomStream random_;
};

}  // namespace drydock::sensor
