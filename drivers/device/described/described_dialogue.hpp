#pragma once

#include <optional>
#include <string_view>

#include "drivers/device/driver.hpp"
#include "drivers/wire/described/description.hpp"

namespace drydock::device {

/// What a description says that the host must say: first the requests of the start, one after the
/// other, each again until its reply comes; then, for a sensor that only answers, its polls at a
/// fixed rate.
class DescribedDialogue {
 public:
  DescribedDialogue(const wire::described::Description& description,
                    std::chrono::nanoseconds poll_period)
      : description_(description), poll_period_(poll_period) {}

  /// The link was opened. `silent`: it plays a recording, so nothing is said.
  void begin(Stamp now, bool silent, Output& out);
  void heard(std::string_view message, Stamp now, Output& out);
  void tick(Stamp now, Output& out);
  std::optional<Stamp> deadline() const { return due_; }

 private:
  bool starts() const { return step_ < description_.start.size(); }
  void say(const wire::described::Request& request, Output& out) const;
  void proceed(Stamp now, Output& out);
  void poll(Stamp now, Output& out);

  const wire::described::Description& description_;
  std::chrono::nanoseconds poll_period_;
  std::size_t step_ = 0;  ///< of the start: the request whose reply is awaited
  int tries_ = 0;
  std::optional<Stamp> due_;
};

}  // namespace drydock::device
