#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

#include "drivers/device/device.hpp"

namespace drydock::device {

/// The health of one device as all outputs tell it: tables, JSON, the bus, recordings, pages.
struct HealthAccount {
  std::string name, kind, protocol, link;
  std::string provenance;  ///< "real", "emulated", "replayed"
  std::string state;       ///< "streaming", ...
  std::string status;      ///< the state in words, and the next step
  double rate_hz = 0;      ///< of its fastest kind of measurement; 0 until there is one
  double nominal_rate_hz = 0;
  std::optional<double> jitter_s, longest_interval_s, age_s;
  std::uint64_t messages = 0, frames = 0;
  std::uint64_t bytes_in = 0, bytes_good = 0, bytes_skipped = 0, bytes_held = 0;
  std::uint64_t bad_checksums = 0;
  std::uint64_t reopens = 0;  ///< how often the link was opened after the first time
  std::uint64_t can_dropped = 0, error_frames = 0;
  std::uint64_t refused =
      0;                   ///< values that were not published: impossible, or of another instance
  std::string left_out;    ///< of them, why the last good one; for people
  std::string last_error;  ///< empty: none so far
  std::optional<double> last_error_age_s;
  std::uint64_t errors = 0;  ///< how many so far, the last one among them
  std::string link_note;     ///< what is special about its link; empty: nothing
};

HealthAccount account_of(const Device& device, const Health& health,
                         measurement::Provenance provenance);

/// Calls `field(name, value)` for every field. These names are the keys of all outputs.
template <class Account, class Field>
requires std::same_as<std::remove_const_t<Account>, HealthAccount>
void visit_fields(Account& account, Field&& field) {
  field("name", account.name);
  field("kind", account.kind);
  field("protocol", account.protocol);
  field("link", account.link);
  field("provenance", account.provenance);
  field("state", account.state);
  field("status", account.status);
  field("rate_hz", account.rate_hz);
  field("nominal_rate_hz", account.nominal_rate_hz);
  field("jitter_s", account.jitter_s);
  field("longest_interval_s", account.longest_interval_s);
  field("age_s", account.age_s);
  field("messages", account.messages);
  field("frames", account.frames);
  field("bytes_in", account.bytes_in);
  field("bytes_good", account.bytes_good);
  field("bytes_skipped", account.bytes_skipped);
  field("bytes_held", account.bytes_held);
  field("bad_checksums", account.bad_checksums);
  field("reopens", account.reopens);
  field("can_dropped", account.can_dropped);
  field("error_frames", account.error_frames);
  field("refused", account.refused);
  field("last_error", account.last_error);
  field("last_error_age_s", account.last_error_age_s);
  field("errors", account.errors);
  field("link_note", account.link_note);
}

}  // namespace drydock::device
