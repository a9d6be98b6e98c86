#include <algorithm>
#include <cmath>

#include "hil/characterize/grade/grade.hpp"
#include "hil/characterize/grade/shipped_grades.hpp"
#include "rig_config/load.hpp"

namespace drydock::characterize {
namespace {

using rig_config::Axes;
using rig_config::SensorErrors;

/// Sum of the logarithms of ratios, over the figures that both have.
struct Distance {
  double sum = 0;
  int figures = 0;

  void add(const Axes& a, const Axes& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (!(a[i] > 0) || !(b[i] > 0)) continue;
      sum += std::abs(std::log(a[i] / b[i]));
      ++figures;
    }
  }
};

std::optional<double> distance(const rig_config::EmulateConfig& a,
                               const rig_config::EmulateConfig& b, rig_config::DeviceKind kind) {
  Distance distance;
  for (const Quantity& quantity : quantities_of(kind)) {
    const auto &of_a = a.*quantity.errors, &of_b = b.*quantity.errors;
    for (const auto part :
         {&SensorErrors::noise, &SensorErrors::noise_density, &SensorErrors::bias_instability})
      distance.add(of_a.*part, of_b.*part);
  }
  if (distance.figures == 0) return std::nullopt;
  return distance.sum / distance.figures;
}

}  // namespace

std::optional<NamedGrade> nearest_shipped(const MeasuredGrade& measured,
                                          rig_config::DeviceKind kind) {
  std::optional<NamedGrade> nearest;
  double least = 0;
  for (const ShippedFile& file : shipped_files()) {
    const auto grade = rig_config::load_sensor_text(file.text, std::string(file.name), kind);
    if (!grade) continue;  // the file has no sensor of this kind
    const auto comparable = in_measured_form(*grade, kind, measured.value.rate_hz.value_or(1));
    const auto here = distance(measured.value, comparable, kind);
    if (!here || (nearest && *here >= least)) continue;
    least = *here;
    nearest = NamedGrade{std::string(file.name), *grade};
  }
  return nearest;
}

}  // namespace drydock::characterize
