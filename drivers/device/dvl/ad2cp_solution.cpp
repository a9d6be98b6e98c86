#include "drivers/device/dvl/ad2cp_solution.hpp"

#include "drivers/device/dvl/velocity_accuracy.hpp"

namespace drydock::device {
namespace {

using wire::ad2cp::Estimates;
using wire::ad2cp::Four;

enum Axis : std::size_t { x, y, z1, z2 };

/// One component and its variance; the variance may be missing.
struct Component {
  std::optional<double> value, variance;
};

Component component(const Estimates& axes, Axis axis) {
  const auto merit = merit_of(axes.figure_of_merit_mps[axis]);
  return {axes.velocity_mps[axis], merit ? std::optional(*merit * *merit) : std::nullopt};
}

Component combined(const Component& a, const Component& b) {
  if (!a.value) return b;
  if (!b.value) return a;
  if (!a.variance || !b.variance) return {(*a.value + *b.value) / 2, {}};
  const double weight_a = 1 / *a.variance, weight_b = 1 / *b.variance;
  const double sum = weight_a + weight_b;
  return {(*a.value * weight_a + *b.value * weight_b) / sum, 1 / sum};
}

std::optional<double> mean(const Four& values) {
  double sum = 0;
  int count = 0;
  for (const auto& value : values) {
    if (!value) continue;
    sum += *value;
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

}  // namespace

Ad2cpSolution solve(const Estimates& axes) {
  Ad2cpSolution solution;
  solution.after_trigger_s = mean(axes.after_trigger_s);
  solution.after_output_s = mean(axes.after_output_s);
  const auto& v = axes.velocity_mps;
  if (v[z1] && v[z2]) solution.error_velocity_mps = *v[z1] - *v[z2];
  const Component ahead = component(axes, x), across = component(axes, y);
  const Component down = combined(component(axes, z1), component(axes, z2));
  if (!ahead.value || !across.value || !down.value) return solution;
  solution.velocity = {*ahead.value, *across.value, *down.value};
  if (ahead.variance && across.variance && down.variance)
    solution.covariance =
        Eigen::Vector3d{*ahead.variance, *across.variance, *down.variance}.asDiagonal();
  return solution;
}

}  // namespace drydock::device
