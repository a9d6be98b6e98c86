#include "drivers/shell/recorded_starts.hpp"

#include <algorithm>
#include <optional>

namespace drydock::shell {

std::vector<Stamp> recorded_starts(std::span<const PlayedFile> files, Stamp start) {
  std::optional<Stamp> first;
  for (const auto& [uri, travels, devices, clock] : files)
    if (clock.pace == Pace::arrival) first = std::min(first.value_or(clock.first), clock.first);
  std::vector<Stamp> starts;
  for (const auto& [uri, travels, devices, clock] : files) {
    const auto after = clock.pace == Pace::arrival ? clock.first - *first : Stamp::duration{0};
    starts.push_back(after < std::chrono::days{1} ? start + after : start);
  }
  return starts;
}

}  // namespace drydock::shell
