#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "drivers/measurement/units.hpp"
#include "estimators/frame/attitude.hpp"
#include "hil/study/velocity/velocity_study.hpp"

namespace drydock::study {
namespace {

constexpr double hours_an_instant = 60.0 / 3600;

report::Curve over_hours(std::string label, std::size_t instants,
                         const std::function<double(std::size_t)>& value) {
  report::Curve curve{std::move(label), {}, {}};
  for (std::size_t i = 0; i < instants; ++i) {
    curve.x.push_back(static_cast<double>(i) * hours_an_instant);
    curve.y.push_back(value(i));
  }
  return curve;
}

/// Figures 5 to 8: the truth.
void add_truth_figures(const std::vector<MissionInstant>& track,
                       std::vector<report::Figure>& figures) {
  report::Curve path{"track", {}, {}};
  for (const auto& at : track) {
    const Eigen::Vector3d ned = frame::ned_offset(track.front().position, at.position);
    path.x.push_back(ned.y() / 1000);
    path.y.push_back(ned.x() / 1000);
  }
  const auto attitude = [&](std::size_t i) { return frame::euler(track[i].body_to_ned); };
  const auto speed = [&](std::size_t i, int axis) { return track[i].velocity_body()(axis); };
  const std::size_t n = track.size();
  figures.push_back({"Fig. 5: horizontal trajectory", "east [km]", "north [km]", {path}});
  figures.back().equal_scales = true;
  figures.push_back(
      {"Fig. 6: vertical trajectory",
       "time [h]",
       "height [m]",
       {over_hours("height", n, [&](auto i) { return track[i].position.height_m; })}});
  figures.push_back(
      {"Fig. 7: attitude",
       "time [h]",
       "deg",
       {over_hours("roll", n, [&](auto i) { return attitude(i).roll * units::degrees_per_radian; }),
        over_hours("pitch", n,
                   [&](auto i) { return attitude(i).pitch * units::degrees_per_radian; }),
        over_hours("yaw", n,
                   [&](auto i) { return attitude(i).yaw * units::degrees_per_radian; })}});
  figures.push_back({"Fig. 8: velocity in body axes",
                     "time [h]",
                     "m/s",
                     {over_hours("u", n, [&](auto i) { return speed(i, 0); }),
                      over_hours("v", n, [&](auto i) { return speed(i, 1); }),
                      over_hours("w", n, [&](auto i) { return speed(i, 2); })}});
}

using EnsembleValue = double (Ensemble::*)(std::size_t) const;

/// Figures 10 and 12: one axis, all methods except `pure`.
void add_velocity_figures(const CaseResult& result, const std::string& title,
                          std::vector<report::Figure>& figures) {
  constexpr std::array axes{"u", "v", "w"};
  const std::pair<const char*, EnsembleValue> parts[]{{"mean", &Ensemble::mean},
                                                      {"standard deviation", &Ensemble::deviation}};
  for (const auto& [part, value] : parts) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      report::Figure figure{
          fmt::format("{}, {} of {}", title, part, axes[axis]), "time [h]", "m/s", {}};
      for (std::size_t m = 1; m < velocity_methods.size(); ++m) {
        const Ensemble& error = result.methods[m].velocity(axis);
        // clang 14 does not let a lambda use a structured binding.
        figure.curves.push_back(
            over_hours(std::string(velocity_methods[m].name), error.instants(),
                       [&, at = value](std::size_t i) { return (error.*at)(i); }));
      }
      figures.push_back(figure);
    }
  }
}

report::Figure position_figure(const CaseResult& result, std::string title,
                               std::size_t first_method) {
  report::Figure figure{std::move(title), "time [h]", "RMS of the horizontal distance [m]", {}};
  for (std::size_t m = first_method; m < velocity_methods.size(); ++m) {
    const auto& s = result.methods[m];
    figure.curves.push_back(over_hours(std::string(velocity_methods[m].name), s.instants(),
                                       [&](std::size_t i) { return s.horizontal_rmse(i); }));
  }
  return figure;
}

report::Figure pure_figure(const CaseResult& result) {
  const auto& s = result.methods[0];
  return {"Fig. 9: RMS position error of the SDINS alone",
          "time [h]",
          "m",
          {over_hours("north", s.instants(), [&](auto i) { return s.north().rms(i); }),
           over_hours("east", s.instants(), [&](auto i) { return s.east().rms(i); }),
           over_hours("horizontal", s.instants(), [&](auto i) { return s.horizontal_rmse(i); }),
           over_hours("vertical", s.instants(), [&](auto i) { return s.up().rms(i); })}};
}

}  // namespace

std::vector<report::Figure> velocity_figures(const VelocityResults& results) {
  std::vector<report::Figure> figures;
  if (!results.track.empty()) add_truth_figures(results.track, figures);
  for (const auto& result : results.cases) {
    const std::string name(result.which.name);
    if (name == "case1") {
      figures.push_back(pure_figure(result));
      add_velocity_figures(result, "Fig. 10: velocity error, case 1", figures);
      figures.push_back(position_figure(result, "Fig. 11: horizontal distance error, case 1", 1));
    } else if (name == "case2") {
      add_velocity_figures(result, "Fig. 12: velocity error, case 2", figures);
      figures.push_back(position_figure(result, "Fig. 13: horizontal distance error, case 2", 1));
    } else {
      figures.push_back(
          position_figure(result, "Not in the paper: " + std::string(result.which.what), 0));
    }
  }
  return figures;
}

}  // namespace drydock::study
