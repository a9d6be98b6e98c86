#pragma once

#include <optional>
#include <string_view>

#include "drivers/device/driver.hpp"
#include "drivers/device/fixed_text.hpp"
#include "drivers/wire/described/description.hpp"
#include "drivers/wire/described/record.hpp"

namespace drydock::device {

/// What a description says that the host must say: first the requests of the start, one after the
/// other, each again until its reply comes; then, for a sensor that only answers, its polls at a
/// fixed rate. It says the start again after a silence and after a refused poll, because the sensor
/// may have lost its power.
class DescribedDialogue {
 public:
  DescribedDialogue(const wire::described::Description& description,
                    std::chrono::nanoseconds poll_period);

  /// The link was opened. `silent`: it plays a recording, so nothing is said.
  void begin(Stamp now, bool silent, Output& out);
  void heard(const wire::described::Record& message, Stamp now, Output& out);
  void tick(Stamp now, Output& out);
  std::optional<Stamp> deadline() const;

  /// Why values are left out: the sensor is not, or not yet, as the start asks. Empty: they count.
  std::string_view objection() const;

 private:
  bool starts() const { return step_ < description_.start.size(); }
  bool awaits_value() const;
  void begin_anew(Stamp now, Output& out);
  void check_values(const wire::described::Record& message, Output& out);
  void hear_reply(std::string_view message, Stamp now, Output& out);
  void hear_refused_poll(std::string_view message, Stamp now, Output& out);
  std::optional<Stamp> silent_at() const;
  void say(const wire::described::Request& request, Output& out) const;
  void proceed(Stamp now, Output& out);
  void poll(Stamp now, Output& out);

  const wire::described::Description& description_;
  std::chrono::nanoseconds poll_period_, patience_;
  bool speaks_ = false;
  std::size_t step_ = 0;  ///< of the start: the request whose reply is awaited
  int tries_ = 0;
  std::optional<Stamp> due_;
  Stamp began_at_{}, heard_at_{};
  Reason objection_;  ///< the sensor said another value; empty: none
};

}  // namespace drydock::device
