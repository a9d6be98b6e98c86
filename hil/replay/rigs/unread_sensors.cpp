#include "hil/replay/rigs/unread_sensors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "drivers/wire/protocols.hpp"

namespace drydock::replay {

std::vector<std::string> unread_sensors(const CapturePart& part, const decode::ReplayOptions& how,
                                        const std::vector<rig_config::DeviceConfig>& readers) {
  std::set<std::string> protocols;
  for (const auto& device : readers) protocols.insert(device.protocol);
  std::vector<std::string> lines;
  for (const auto& protocol : protocols) {
    const wire::Protocol* known = wire::find_protocol(protocol);
    for (const auto kind : measurement::kinds) {
      const bool is_read = std::ranges::any_of(readers, [&](const auto& device) {
        return device.protocol == protocol && device.kind == kind;
      });
      if (known == nullptr || !known->kinds.has(kind) || is_read) continue;
      decode::ReplayOptions as_this = how;
      as_this.protocol = protocol;
      as_this.kind = to_string(kind);
      if (const auto measurements = measurements_of(part, std::move(as_this)); measurements > 0)
        lines.push_back(
            fmt::format("{}: {} of {}, {} measurements: no device of this rig reads them",
                        in_words(part), to_string(kind), protocol, measurements));
    }
  }
  return lines;
}

}  // namespace drydock::replay
