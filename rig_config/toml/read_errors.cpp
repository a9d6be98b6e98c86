#include "rig_config/rules/error_keys.hpp"
#include "rig_config/toml/read_keys.hpp"
#include "rig_config/typed/build.hpp"

namespace drydock::rig_config {

void read_errors(const Node& table, DeviceKind kind, EmulateConfig& into) {
  for (const ErrorKey& error : error_keys)
    if (error.kind == kind) read(table, error.key, into.*error.quantity.*error.part, error.unit);
  for (const CorrelationKey& time : correlation_keys)
    if (time.kind == kind) read(table, time.key, (into.*time.quantity).correlation_s);
  read(table, "quantisation_carried", into.primary.quantisation_carried);
  read(table, "quantisation_carried", into.secondary.quantisation_carried);
  read(table, "fixed_bias", into.fixed_bias);
  read(table, "latency_ms", into.latency_s, millisecond);
  read(table, "boot_s", into.boot_s);
  read(table, "banner", into.banner);
  read(table, "first_fix_s", into.first_fix_s);
  read(table, "dropout_probability", into.dropout.probability);
  read(table, "dropout_mean_samples", into.dropout.mean_samples);
  if (const auto rate = read_if(table, "rate_hz")) into.rate_hz = rate;
  if (const auto noise = read_if(table, "power_noise")) into.power_noise = noise;
}

}  // namespace drydock::rig_config
