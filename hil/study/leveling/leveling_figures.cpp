#include <fmt/format.h>

#include <array>
#include <cmath>

#include "hil/study/leveling/leveling_covariance.hpp"
#include "hil/study/leveling/leveling_study.hpp"

namespace drydock::study {
namespace {

constexpr double zoomed_limit_deg = 0.2;  // four times the error that a bias of 1 mg leaves
constexpr std::size_t s_path_case = 0, stationary_case = 1, augmented_filter = 2;
static_assert(leveling_cases[s_path_case].name == "moving_s" &&
              leveling_cases[stationary_case].name == "stationary" &&
              leveling_filters[augmented_filter].name == "augmented");

std::vector<double> point_times() {
  std::vector<double> t(leveling_points);
  for (std::size_t i = 0; i < t.size(); ++i)
    t[i] = static_cast<double>(i) * leveling_point_spacing_s;
  return t;
}

template <class Value>
report::Curve over_time(std::string label, Value&& value) {
  report::Curve curve{std::move(label), point_times(), {}};
  for (std::size_t i = 0; i < leveling_points; ++i) curve.y.push_back(value(i));
  return curve;
}

using AxisOf = Ensemble LevelingStatistics::*;
using FigureOf = double (Ensemble::*)(std::size_t) const;

/// One of Figures 6 to 9 for one axis with all filters: the whole time, and a zoom on the final
/// errors.
void add_ensemble_figures(std::vector<report::Figure>& figures, const std::string& title,
                          const std::string& y_label, const ByFilter<LevelingStatistics>& results,
                          FigureOf what) {
  using S = LevelingStatistics;
  struct Axis {
    const char* name;
    AxisOf error, kept;
  };
  for (const Axis axis :
       {Axis{"roll", &S::roll, &S::kept_roll}, Axis{"pitch", &S::pitch, &S::kept_pitch}}) {
    report::Figure figure{fmt::format("{}: {}", title, axis.name), "time [s]", y_label, {}};
    for (std::size_t f = 0; f < leveling_filters.size(); ++f) {
      const Ensemble& errors = results[f].*axis.error;
      figure.curves.push_back(over_time(std::string(leveling_filters[f].name),
                                        [&](std::size_t i) { return (errors.*what)(i); }));
    }
    if (const auto& paper = results.front(); paper.diverged > 0 && paper.diverged < paper.runs())
      figure.curves.push_back(over_time(
          "paper, kept runs", [&](std::size_t i) { return ((paper.*axis.kept).*what)(i); }));
    figures.push_back(figure);
    figure.title += ", enlarged";
    figure.y_limit = zoomed_limit_deg;
    figures.push_back(figure);
  }
}

/// As the paper draws it, and with a scale that shows the end.
void add_covariance_figures(std::vector<report::Figure>& figures, const std::string& title,
                            const LevelingMotion& motion, bool stationary) {
  const auto analysis = analyse_leveling(motion, stationary);
  report::Figure figure{title, "time [s]", "error covariance", {}};
  constexpr std::array labels{"x4 = -sin(pitch)", "x5 = sin(roll) cos(pitch)",
                              "x6 = cos(roll) cos(pitch)"};
  for (std::size_t k = 0; k < labels.size(); ++k)
    figure.curves.push_back({labels[k], analysis.t_s, analysis.variance[k]});
  figures.push_back(figure);
  figure.title += ", logarithmic";
  figure.log_y = true;
  figures.push_back(figure);
}

report::Figure path_figure(std::string title, const LevelingMotion& motion) {
  report::Curve curve{"path", {0}, {0}};
  constexpr double step = 0.01, half_width_m = 100;
  const auto steps = std::lround(leveling_duration_s / step);
  for (long i = 0; i < steps; ++i) {
    const double t = (static_cast<double>(i) + 0.5) * step;
    const Eigen::Vector3d ned = frame::body_to_ned(motion.attitude(t)) * motion.velocity(t) * step;
    curve.x.push_back(curve.x.back() + ned.x());
    curve.y.push_back(curve.y.back() + ned.y());
  }
  return {std::move(title), "north [m]", "east [m]", {curve}, half_width_m, true};
}

/// RMS error and the filter's own standard deviation. If the error is larger, the filter is
/// overconfident.
report::Figure belief_figure(const char* axis, const LevelingStatistics& s, AxisOf error,
                             AxisOf variance) {
  return {fmt::format("Not in the paper: augmented filter, S path, drawn biases: {}", axis),
          "time [s]",
          "deg",
          {over_time("RMS error", [&](std::size_t i) { return (s.*error).rms(i); }),
           over_time("the filter's own 1 sigma",
                     [&](std::size_t i) { return std::sqrt((s.*variance).mean(i)); })},
          zoomed_limit_deg};
}

}  // namespace

std::vector<report::Figure> leveling_figures(const LevelingResults& results) {
  using namespace leveling_motions;
  std::vector<report::Figure> figures;
  add_covariance_figures(figures, "Fig. 3: error covariance, stationary", stationary, true);
  add_covariance_figures(figures, "Fig. 4 (a): error covariance, moving straight", straight, false);
  add_covariance_figures(figures, "Fig. 4 (b): error covariance, moving on the S path", s_path,
                         false);
  figures.push_back(path_figure("Fig. 5 (a): straight trajectory", straight));
  figures.push_back(path_figure("Fig. 5 (b): S-type trajectory; the paper's is lost", s_path));
  const auto& fixed = results[0];
  const std::string mean = "mean of the error [deg]", deviation = "standard deviation [deg]";
  add_ensemble_figures(figures, "Fig. 6: ensemble mean, moving", mean, fixed[s_path_case],
                       &Ensemble::mean);
  add_ensemble_figures(figures, "Fig. 7: standard deviation, moving", deviation, fixed[s_path_case],
                       &Ensemble::deviation);
  add_ensemble_figures(figures, "Fig. 8: ensemble mean, stationary", mean, fixed[stationary_case],
                       &Ensemble::mean);
  add_ensemble_figures(figures, "Fig. 9: standard deviation, stationary", deviation,
                       fixed[stationary_case], &Ensemble::deviation);
  const auto& augmented = results[1][s_path_case][augmented_filter];
  figures.push_back(belief_figure("roll", augmented, &LevelingStatistics::roll,
                                  &LevelingStatistics::roll_variance));
  figures.push_back(belief_figure("pitch", augmented, &LevelingStatistics::pitch,
                                  &LevelingStatistics::pitch_variance));
  return figures;
}

}  // namespace drydock::study
