#include "drivers/host/late_wakes.hpp"

#include <fmt/format.h>

namespace drydock::host {

std::string LateWakes::note() const {
  if (count_ == 0) return {};
  return fmt::format(
      "this computer was busy: it woke this program {} late, by up to {:.0f} ms; no sensor is "
      "blamed "
      "for that, and jitter below it could not be told",
      count_ == 1 ? "once" : fmt::format("{} times", count_), measurement::seconds(most_) * 1e3);
}

}  // namespace drydock::host
