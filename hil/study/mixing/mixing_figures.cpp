#include <fmt/format.h>

#include "hil/study/mixing/mixing_study.hpp"

namespace drydock::study {
namespace {

constexpr std::size_t mixing_drawn_every = 10;  // points drawn: one a second
constexpr std::array<const char*, 4> mixing_curve_names{"type 1", "type 2", "type 3",
                                                        "compensated"};

template <class Value>
report::Curve mixing_curve(std::string label, Value&& value) {
  report::Curve curve{std::move(label), {}, {}};
  for (std::size_t i = mixing_drawn_every - 1; i < mixing_points; i += mixing_drawn_every) {
    curve.x.push_back(static_cast<double>(i + 1) * mixing_point_spacing_s);
    curve.y.push_back(value(i));
  }
  return curve;
}

report::Figure trajectory_plan(const MixingExperiment& experiment) {
  report::Figure figure{"Figure 9: trajectory", "east [m]", "north [m]", {}, 0, true};
  report::Curve& path = figure.curves.emplace_back(report::Curve{"path", {}, {}});
  for (std::size_t i = 0; i < mixing_points; i += mixing_drawn_every) {
    path.x.push_back(experiment.points[i].east_m);
    path.y.push_back(experiment.points[i].north_m);
  }
  return figure;
}

report::Figure trajectory_depth(const MixingExperiment& experiment) {
  report::Figure figure{"Figure 9: trajectory, depth", "time [s]", "depth [m]", {}};
  figure.y_down = true;
  figure.curves = {mixing_curve("depth", [&](auto i) { return experiment.points[i].depth_m; })};
  return figure;
}

/// Figure 8: the levels of Table 3, and the inference between its boundaries.
report::Figure mixing_levels() {
  report::Figure figure{"Figure 8: level of manoeuvring", "velocity rate [m/s2]", "level", {}};
  for (int row = 0; row < 4; ++row) {
    const double rate = 0.01 * row;
    report::Curve curve{fmt::format("{:.2f} rad/s", rate), {}, {}};
    for (int i = 0; i <= 250; ++i) {
      curve.x.push_back(0.02 * i);
      curve.y.push_back(mixing::inferred_level(rate, 0.02 * i, mixing::pointed_sets));
    }
    figure.curves.push_back(std::move(curve));
  }
  return figure;
}

/// Figures 10 to 13 for one reading of the integral gain.
void add_mixing_errors(std::vector<report::Figure>& figures, const MixingResults& results,
                       mixing::IntegralGain reading) {
  struct Drawn {
    const char* title;
    Ensemble MixingStatistics::*error;
    double (Ensemble::*value)(std::size_t) const;
  };
  const bool printed = reading == mixing::IntegralGain::k1_k2;
  for (const Drawn& drawn :
       {Drawn{"Figure 10: mean of roll angle error", &MixingStatistics::roll, &Ensemble::mean},
        Drawn{"Figure 11: standard deviation of roll angle error", &MixingStatistics::roll,
              &Ensemble::deviation},
        Drawn{"Figure 12: mean of pitch angle error", &MixingStatistics::pitch, &Ensemble::mean},
        Drawn{"Figure 13: standard deviation of pitch angle error", &MixingStatistics::pitch,
              &Ensemble::deviation}}) {
    report::Figure figure{
        fmt::format("{}, integral gain {}", drawn.title, printed ? "K1 K2" : "K2"),
        "time [s]",
        "error [deg]",
        {}};
    for (std::size_t type = 0; type < mixing_types.size(); ++type) {
      const auto& error = results[printed ? type : mixing_types.size() + type].*drawn.error;
      figure.curves.push_back(mixing_curve(mixing_curve_names[type],
                                           [&](std::size_t i) { return (error.*drawn.value)(i); }));
    }
    figures.push_back(std::move(figure));
  }
}

}  // namespace

std::vector<report::Figure> mixing_figures(const MixingExperiment& experiment,
                                           const MixingResults& results) {
  std::vector<report::Figure> figures{mixing_levels(), trajectory_plan(experiment),
                                      trajectory_depth(experiment)};
  add_mixing_errors(figures, results, mixing::IntegralGain::k1_k2);
  add_mixing_errors(figures, results, mixing::IntegralGain::k2_alone);
  return figures;
}

}  // namespace drydock::study
