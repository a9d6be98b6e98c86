#include "hil/twin/lapse_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace drydock::twin {
namespace {

/// The fault begins and ends half a step from the samples that are there.
std::string block(const std::string& device, std::string_view words, double from_s, double to_s) {
  const double begin_s = std::max(from_s, 0.0);
  if (to_s <= begin_s) return {};
  return fmt::format("\n[[fault]]\ndevice = \"{}\"\n{}\nstart_s = {:.3f}\nfor_s = {:.3f}\n", device,
                     words, begin_s, to_s - begin_s);
}

}  // namespace

std::string lapse_text(const DeviceStatistics& statistics, const std::string& device,
                       rig_config::DeviceKind kind, measurement::Stamp start) {
  if (!(statistics.timing.rate_hz > 0)) return {};
  const double half_s = 0.5 / statistics.timing.rate_hz;
  const auto since_start = [&](measurement::Stamp at) { return measurement::seconds(at - start); };
  std::string text;
  for (const auto& gap : statistics.timing.long_gaps)
    text += block(device, "fault = \"drop\"\nprobability = 1", since_start(gap.from) + half_s,
                  since_start(gap.to) - half_s);
  if (kind != rig_config::DeviceKind::dvl) return text;
  for (const auto& run : statistics.empty_runs)
    text += block(device, "fault = \"bottom-lost\"", since_start(run.from) - half_s,
                  since_start(run.to) + half_s);
  return text;
}

}  // namespace drydock::twin
