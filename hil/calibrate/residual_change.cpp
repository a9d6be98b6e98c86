#include "hil/calibrate/residual_change.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace drydock::calibrate {
namespace {

/// Sums over the axes that were compared.
struct Sum {
  double squares = 0, normalised = 0;
  int count = 0;

  void add(const std::array<smoothing::Residual, 3>& axes) {
    for (const auto& axis : axes) {
      if (!axis.known) continue;
      squares += axis.value * axis.value;
      normalised += axis.normalised() * axis.normalised();
      ++count;
    }
  }
  double rms() const { return count > 0 ? std::sqrt(squares / count) : 0; }
  double nis() const { return count > 0 ? normalised / count : 0; }
};

}  // namespace

std::vector<ResidualChange> residual_changes(const Outcome& outcome) {
  std::map<std::pair<std::uint16_t, smoothing::Quantity>, std::pair<Sum, Sum>> sums;
  const auto& readings = outcome.gathered.dive.readings;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    auto& [before, after] = sums[{readings[i].device, readings[i].quantity}];
    before.add(outcome.before.at(i));
    after.add(outcome.after.at(i));
  }
  std::vector<ResidualChange> changes;
  changes.reserve(sums.size());
  for (const auto& [of, sum] : sums)
    changes.push_back({of.first, of.second, sum.first.rms(), sum.second.rms(), sum.first.nis(),
                       sum.second.nis()});
  return changes;
}

}  // namespace drydock::calibrate
