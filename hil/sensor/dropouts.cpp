#include "hil/sensor/dropouts.hpp"

namespace drydock::sensor {

Dropouts::Dropouts(const rig_config::DropoutConfig& config, std::uint64_t seed,
                   std::string_view device)
    : begin_(config.probability),
      last_(1 - 1 / config.mean_samples),
      random_(seed, device, "dropouts") {}

bool Dropouts::next_is_lost() {
  if (begin_ == 0) return false;
  out_ = random_.uniform() < (out_ ? last_ : begin_);
  return out_;
}

}  // namespace drydock::sensor
