#include "hil/study/velocity/velocity_study.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "hil/study/perturbation.hpp"

namespace drydock::study {
namespace {

/// The vehicle model that the methods use in one run and case.
hydrodynamics::Model known_model(const hydrodynamics::Vehicle& vehicle, double sigma,
                                 std::uint64_t seed, std::size_t run) {
  const std::uint64_t of_run = stream_of(seed, run, "coefficients").next();
  return hydrodynamics::Model{perturbed(vehicle, of_run, sigma)};
}

VelocityErrors errors_of(const VelocityGroup& group) {
  VelocityErrors errors;
  if (group.log_errors) {
    errors.log_scale = 0.005;
    errors.log_bias_mps = 0.005;
  }
  return errors;
}

RecordedMission mission_of(const VelocityGroup& group) {
  const double towards = group.current_towards_deg * std::numbers::pi / 180;
  return record_velocity_mission(
      group.hull, group.current_mps * Eigen::Vector2d{std::cos(towards), std::sin(towards)});
}

/// Runs every method in every case of a group on the same sensors, in the runs `run`, `run` + 1,
/// ... `pure` uses no vehicle model and runs only once.
std::vector<std::vector<VelocityTrial>> run_group(const VelocityGroup& group,
                                                  const RecordedMission& mission,
                                                  const hydrodynamics::Vehicle& vehicle,
                                                  const Options& options, std::size_t run,
                                                  std::size_t runs) {
  std::vector<std::vector<hydrodynamics::Model>> models(runs);
  std::vector<std::vector<Contender>> contenders(runs);
  for (std::size_t k = 0; k < runs; ++k) {
    for (const auto& which : group.cases)
      models[k].push_back(known_model(vehicle, which.coefficient_sigma, options.seed, run + k));
    contenders[k] = {{Method::pure, &models[k][0]}};
    for (const auto& model : models[k])
      for (const auto method : {Method::earlier, Method::paper, Method::ours})
        contenders[k].push_back({method, &model});
  }
  return velocity_trials(mission, errors_of(group), group.gaps, options.seed, run, contenders,
                         registers_for(runs, options.registers));
}

std::size_t study_group(const VelocityGroup& group, const Options& options, Progress& progress,
                        VelocityResults& results) {
  const RecordedMission mission = mission_of(group);
  const hydrodynamics::Vehicle vehicle = mission_vehicle(group.hull);
  const std::size_t instants = mission.steps() / VelocityTrial::steps_an_instant + 1;
  std::vector<CaseResult> cases;
  for (const auto& which : group.cases)
    cases.push_back({which, std::vector(velocity_methods.size(), VelocityStatistics(instants))});
  if (results.track.empty())
    for (std::size_t i = 0; i < instants; ++i)
      results.track.push_back(mission.instants[i * VelocityTrial::steps_an_instant]);
  const std::size_t done = campaign_by_batches(
      group.name, options, registers_for(most_runs, options.registers).width, progress,
      [&](std::size_t run, std::size_t runs) {
        return run_group(group, mission, vehicle, options, run, runs);
      },
      [&](std::size_t, std::vector<VelocityTrial>&& trials) {
        for (std::size_t c = 0; c < cases.size(); ++c) {
          cases[c].methods[0].add(trials[0]);
          for (std::size_t m = 1; m < velocity_methods.size(); ++m)
            cases[c].methods[m].add(trials[3 * c + m]);
        }
      });
  if (done > 0) results.cases.insert(results.cases.end(), cases.begin(), cases.end());
  return done;
}

struct Source {
  std::string_view name;
  std::function<void(const VelocityErrors& all, VelocityErrors& only)> put_in;
  double coefficient_sigma = 0;
};

std::vector<Source> sources() {
  using E = VelocityErrors;
  return {
      {"initial position",
       [](const E& all, E& only) {
         only.position_m = all.position_m;
         only.height_m = all.height_m;
       }},
      {"initial velocity", [](const E& all, E& only) { only.velocity_mps = all.velocity_mps; }},
      {"alignment", [](const E& all, E& only) { only.alignment_rad = all.alignment_rad; }},
      {"gyro bias", [](const E& all, E& only) { only.gyro_bias_radps = all.gyro_bias_radps; }},
      {"accelerometer bias",
       [](const E& all, E& only) { only.accel_bias_mps2 = all.accel_bias_mps2; }},
      {"scale factors", [](const E& all, E& only) { only.scale = all.scale; }},
      {"IMU noise",
       [](const E& all, E& only) {
         only.angle_noise_rad = all.angle_noise_rad;
         only.velocity_noise_mps = all.velocity_noise_mps;
       }},
      {"depth noise", [](const E& all, E& only) { only.depth_m = all.depth_m; }},
      {"log noise", [](const E& all, E& only) { only.log_mps = all.log_mps; }},
      {"DVL noise", [](const E& all, E& only) { only.ground_mps = all.ground_mps; }},
      {"coefficients 10 %", [](const E&, E&) {}, 0.1},
      {"all but initial position",
       [](const E& all, E& only) {
         only = all;
         only.position_m = only.height_m = 0;
       },
       0.1},
      {"all", [](const E& all, E& only) { only = all; }, 0.1},
  };
}

VelocityErrors no_errors() {
  VelocityErrors none;
  none.position_m = none.height_m = none.velocity_mps = none.scale = 0;
  none.alignment_rad.setZero();
  none.accel_bias_mps2 = none.gyro_bias_radps = none.angle_noise_rad = none.velocity_noise_mps = 0;
  none.depth_m = none.log_mps = none.ground_mps = 0;
  return none;
}

/// `ours` in case 2 with one source of error at a time, with a tenth of the runs.
std::size_t study_budget(const Options& options, Progress& progress, VelocityResults& results) {
  Options fewer = options;
  fewer.runs = std::max<std::size_t>(options.runs / 10, 1);
  const RecordedMission mission = mission_of({});
  const hydrodynamics::Vehicle vehicle = mission_vehicle(Hull::symmetric);
  const auto all = sources();
  std::vector<double> square(all.size(), 0);
  const std::size_t done = campaign(
      "error budget", fewer, progress,
      [&](std::size_t run) {
        std::vector<double> ends;
        for (const Source& source : all) {
          VelocityErrors errors = no_errors();
          source.put_in(VelocityErrors{}, errors);
          const auto model = known_model(vehicle, source.coefficient_sigma, options.seed, run);
          const Contender ours{Method::ours, &model};
          const auto trial =
              velocity_trial(mission, errors, false, options.seed, run, {&ours, 1}).front();
          ends.push_back(std::hypot(trial.north_m.back(), trial.east_m.back()));
        }
        return ends;
      },
      [&](std::size_t, std::vector<double>&& ends) {
        for (std::size_t i = 0; i < ends.size(); ++i) square[i] += ends[i] * ends[i];
      });
  results.budget_runs = done;
  for (std::size_t i = 0; done > 0 && i < all.size(); ++i)
    results.budget.push_back({all[i].name, std::sqrt(square[i] / static_cast<double>(done))});
  return done == fewer.runs ? options.runs : 0;
}

constexpr std::string_view budget_name = "error_budget";

bool asked_for(const Options& options, std::string_view name) {
  return options.cases.empty() || std::ranges::find(options.cases, name) != options.cases.end();
}

std::vector<VelocityGroup> groups_asked_for(const Options& options) {
  auto groups = velocity_groups();
  for (auto& group : groups)
    std::erase_if(group.cases, [&](auto& which) { return !asked_for(options, which.name); });
  std::erase_if(groups, [](const VelocityGroup& group) { return group.cases.empty(); });
  return groups;
}

}  // namespace

std::vector<std::string_view> velocity_case_names() {
  std::vector<std::string_view> names;
  for (const auto& group : velocity_groups())
    for (const auto& which : group.cases) names.push_back(which.name);
  names.push_back(budget_name);
  return names;
}

Result velocity_study(const Options& options, Progress& progress) {
  VelocityResults results;
  std::size_t done = 0, parts = 0;
  const auto study_part = [&](const auto& part) {
    ++parts;
    if (!progress.stopped()) done += part();
  };
  for (const auto& group : groups_asked_for(options))
    study_part([&] { return study_group(group, options, progress, results); });
  if (asked_for(options, budget_name))
    study_part([&] { return study_budget(options, progress, results); });

  Result result;
  if (results.cases.empty() && results.budget.empty()) return result;
  // After a stop the last cases have fewer runs or none. This is the average over all cases.
  result.runs = std::max<std::size_t>(done / parts, 1);
  result.tables = velocity_tables(results);
  result.figures = velocity_figures(results);
  result.json = velocity_json(results);
  return result;
}

}  // namespace drydock::study
