#include "hil/twin/sensor_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/measurement/kind.hpp"
#include "drivers/measurement/units.hpp"

namespace drydock::twin {
namespace {

using measurement::Kind;

/// How a sensor file names the errors of a quantity; the unit of each in SI. No name: it has no
/// such key.
struct Keys {
  std::string_view prefix;
  std::string_view bias_unit, noise_unit, slow_unit;
  double bias_si = 1, noise_si = 1;
};

Keys keys_of(Kind kind, int place) {
  using namespace units;
  constexpr double milli_g = 1e3 * micro_g;
  switch (kind) {
    case Kind::imu:
      return place == 0 ? Keys{"gyro", "degph", "degph", "degph", degree_per_hour, degree_per_hour}
                        : Keys{"accelerometer", "mg", "ug", "ug", milli_g, micro_g};
    case Kind::dvl: return {"velocity", "mps", "mps", "mps"};
    case Kind::emlog: return {"speed", "mps", "mps", "mps"};
    case Kind::gnss:
      return place == 0 ? Keys{"position", "m", "m", "m"} : Keys{"velocity", "", "mps", "mps"};
    case Kind::depth: return {"pressure", "pa", "pa", "pa"};
    case Kind::attitude:
      return place == 0 ? Keys{"attitude", "deg", "deg", "deg", degree, degree}
                        : Keys{"turn", "degps", "degps", "", degree, degree};
    case Kind::actuator: break;
  }
  return {};
}

/// One figure for each axis; an axis that was not seen has none.
template <class Of>
std::string line(std::string_view key, std::string_view unit, double si, const QuantityNoise& noise,
                 Of&& of) {
  const auto value = [&](std::size_t axis) {
    return noise.axes.at(axis) ? of(*noise.axes.at(axis)) / si : 0.0;
  };
  if (unit.empty() || (value(0) == 0 && value(1) == 0 && value(2) == 0)) return {};
  if (noise.quantity.axes[1].empty()) return fmt::format("{}_{} = {:.4g}\n", key, unit, value(0));
  return fmt::format("{}_{} = [{:.4g}, {:.4g}, {:.4g}]\n", key, unit, value(0), value(1), value(2));
}

std::string quantity_text(const QuantityNoise& noise, Kind kind, bool coarse) {
  const auto keys = keys_of(kind, noise.quantity.place);
  const std::string prefix(keys.prefix);
  if (prefix.empty()) return {};
  std::string text = line(prefix + "_noise", keys.noise_unit, keys.noise_si, noise,
                          [](const AxisNoise& axis) { return axis.white; });
  if (coarse) return text;
  text += line(prefix + "_bias", keys.bias_unit, keys.bias_si, noise,
               [](const AxisNoise& axis) { return axis.mean; });
  const auto slow = line(prefix + "_bias_instability", keys.slow_unit, keys.noise_si, noise,
                         [](const AxisNoise& axis) { return axis.slow; });
  if (slow.empty()) return text;
  double longest_s = 0;
  for (const auto& axis : noise.axes)
    if (axis) longest_s = std::max(longest_s, axis->correlation_s);
  return text + slow + fmt::format("{}_correlation_s = {:.4g}\n", prefix, longest_s);
}

}  // namespace

std::string sensor_text(const DeviceStatistics& statistics, Kind kind, bool coarse) {
  std::string text = fmt::format("[{}]\n", to_string(kind));
  for (const auto& noise : statistics.quantities) text += quantity_text(noise, kind, coarse);
  const auto& timing = statistics.timing;
  const auto outages = static_cast<double>(timing.outages - timing.long_gaps.size());
  const auto lost = static_cast<double>(timing.lost - timing.lost_in_long_gaps);
  if (outages > 0) {
    text += fmt::format("dropout_probability = {:.4g}\n",
                        outages / static_cast<double>(timing.samples));
    text += fmt::format("dropout_mean_samples = {:.4g}\n", std::max(1.0, lost / outages));
  }
  return text;
}

}  // namespace drydock::twin
