#include "drivers/device/health_account.hpp"

namespace drydock::device {

HealthAccount account_of(const Device& device, const Health& health,
                         measurement::Provenance provenance) {
  const auto& options = device.options();
  HealthAccount account;
  account.name = device.name();
  account.kind = to_string(options.driver.kind);
  account.protocol = options.driver.protocol;
  account.link = options.link;
  account.provenance = to_string(provenance);
  account.state = to_string(health.state);
  account.status = health.status.view();
  account.rate_hz = health.rate_hz.value_or(0);
  account.nominal_rate_hz = health.nominal_rate_hz;
  if (health.jitter) {
    account.jitter_s = health.jitter->deviation_s;
    account.longest_interval_s = health.jitter->longest_interval_s;
  }
  if (health.age) account.age_s = measurement::seconds(*health.age);
  account.messages = health.messages;
  account.frames = health.stream.frames;
  account.bytes_in = health.stream.bytes_in;
  account.bytes_good = health.stream.bytes_good;
  account.bytes_skipped = health.stream.bytes_skipped;
  account.bytes_held = health.held_bytes;
  account.bad_checksums = health.stream.bad_checksums;
  account.reopens = health.reopened;
  account.can_dropped = health.can_dropped;
  account.error_frames = health.error_frames;
  account.refused = health.refused;
  account.left_out = health.left_out.view();
  account.last_error = health.last_error.view();
  if (health.last_error_age)
    account.last_error_age_s = measurement::seconds(*health.last_error_age);
  account.errors = health.errors;
  account.link_note = health.link_note.view();
  return account;
}

}  // namespace drydock::device
