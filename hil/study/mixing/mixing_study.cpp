#include "hil/study/mixing/mixing_study.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>

namespace drydock::study {
namespace {

using MixingJson = nlohmann::ordered_json;

MixingJson mixing_json(const MixingStatistics& s) {
  return {{"roll_std_deg", MixingStatistics::cruise_deviation(s.roll)},
          {"pitch_std_deg", MixingStatistics::cruise_deviation(s.pitch)},
          {"roll_mean_peak_deg", MixingStatistics::mean_peak(s.roll)},
          {"pitch_mean_peak_deg", MixingStatistics::mean_peak(s.pitch)},
          {"pitch_mean_peak_135_165_deg", s.acceleration_peak()},
          {"max_std_deg", s.largest_deviation()},
          {"nees_mean", s.nees_mean()}};
}

/// The JSON key of a variant's figures inside those of its type; empty: directly in the type.
std::string_view mixing_place(const MixingVariant& variant) {
  if (variant.as_printed) return "as_printed";
  if (variant.noisy_log) return "noisy_log";
  return variant.integral_gain == mixing::IntegralGain::k2_alone ? "integral_gain_k2" : "";
}

MixingJson mixing_json(const MixingResults& results) {
  MixingJson json;
  json["table3_cells_matched"] = mixing_table3_cells();
  for (std::size_t i = 0; i < results.size(); ++i) {
    const MixingVariant& variant = mixing_variants[i];
    const std::string place(mixing_place(variant));
    MixingJson& type = json[std::string(variant.key)];
    (place.empty() ? type : type[place]) = mixing_json(results[i]);
  }
  return json;
}

std::string mixing_name(const MixingVariant& variant) {
  if (variant.as_printed) return fmt::format("{}, as printed", variant.key);
  if (variant.noisy_log) return fmt::format("{}, log noise 0.02 m/s", variant.key);
  return std::string(variant.key);
}

report::Table mixing_error_table(const MixingResults& results) {
  report::Table table{
      "Errors over 600 s [deg]",
      {"algorithm", "integral gain", "roll std", "pitch std", "roll peak", "pitch peak",
       "135-165 s", "max std", "NEES"},
      {{"type1, published", "not said", "0.3", "0.3", "large", "large", "large", "", ""},
       {"type2, published", "not said", "0.15", "0.15", "0", "0.1", "0.1", "", ""},
       {"type3, published", "not said", "0.15", "0.15", "0", "0.1", "0.1", "", ""}},
      "std: over the runs, mean of 300 s to 560 s; the sensors' floor is 0.13 to 0.14. peak: "
      "largest mean over\nthe runs; 135-165 s: that of pitch in the acceleration. as "
      "printed: without low-pass of the inference's\ninputs. NEES: errors squared over the "
      "variance that the loop's gains give known sensors; 1 is consistent."};
  for (std::size_t i = 0; i < results.size(); ++i) {
    const MixingStatistics& s = results[i];
    const bool product = mixing_variants[i].integral_gain == mixing::IntegralGain::k1_k2;
    const auto cell = [](double deg) { return fmt::format("{:.3f}", deg); };
    table.rows.push_back({mixing_name(mixing_variants[i]), product ? "K1 K2" : "K2",
                          cell(MixingStatistics::cruise_deviation(s.roll)),
                          cell(MixingStatistics::cruise_deviation(s.pitch)),
                          cell(MixingStatistics::mean_peak(s.roll)),
                          cell(MixingStatistics::mean_peak(s.pitch)), cell(s.acceleration_peak()),
                          cell(s.largest_deviation()), fmt::format("{:.3g}", s.nees_mean())});
  }
  return table;
}

report::Table mixing_level_table() {
  report::Table table{
      fmt::format("Table 3: level of manoeuvring by inference, {} of 36 cells as published",
                  mixing_table3_cells()),
      {"rad/s \\ m/s2", "0", "1", "2", "3", "4", "5"},
      {},
      ""};
  for (int i = 0; i < 6; ++i) {
    auto& row = table.rows.emplace_back(1, fmt::format("{:.2f}", 0.01 * i));
    for (int j = 0; j < 6; ++j)
      row.push_back(std::to_string(mixing::inferred_level(0.01 * i, j, mixing::FuzzySets{})));
  }
  return table;
}

}  // namespace

int mixing_table3_cells() {
  int matched = 0;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      matched += mixing::inferred_level(0.01 * static_cast<double>(i), static_cast<double>(j),
                                        mixing::FuzzySets{}) == mixing::level_table[i][j];
  return matched;
}

Result mixing_study(const Options& options, Progress& progress) {
  using Outcomes = std::array<MixingOutcome, mixing_variants.size()>;
  const MixingExperiment experiment;
  const auto results = std::make_unique<MixingResults>();
  Result result;
  result.runs = campaign(
      "mixing", options, progress,
      [&](std::size_t run) {
        const auto readings = mixing_readings(experiment, options.seed, run);
        Outcomes outcomes;
        for (std::size_t i = 0; i < outcomes.size(); ++i)
          outcomes[i] = mixing_run(mixing_variants[i], experiment, readings);
        return outcomes;
      },
      [&](std::size_t, const Outcomes& outcomes) {
        for (std::size_t i = 0; i < outcomes.size(); ++i) (*results)[i].add(outcomes[i]);
      });
  if (result.runs == 0) return result;
  result.tables = {mixing_error_table(*results), mixing_level_table()};
  result.figures = mixing_figures(experiment, *results);
  result.json = mixing_json(*results);
  return result;
}

std::vector<Workload> mixing_workloads() {
  constexpr std::size_t first = 4000, kept = 16'384;  // circle and acceleration, 40 s to 204 s
  const auto experiment = std::make_shared<MixingExperiment>();
  auto all = mixing_readings(*experiment, 1, 0);
  const auto readings = std::make_shared<const std::vector<MixingReading>>(
      all.begin() + first, all.begin() + first + kept);
  // Each filter continues from its last state. After the last reading the first one follows again.
  const auto stepping = [&](const MixingVariant& variant, auto&& besides) {
    auto filter = std::make_shared<mixing::MixingFilter>(mixing_options(variant, *experiment));
    return [=, k = std::size_t{0}](std::size_t steps) mutable {
      for (; steps > 0; --steps) {
        const MixingReading& r = (*readings)[k++ % kept];
        filter->step(r.force, r.rate, r.speed_mps, mixing_step_s);
        besides(*filter, r);
      }
    };
  };
  const auto nothing = [](const mixing::MixingFilter&, const MixingReading&) {};
  std::vector<Workload> workloads;
  for (std::size_t i = 0; i < mixing_types.size(); ++i)
    workloads.push_back({std::string(mixing_types[i]), std::string(mixing_types[i]),
                         stepping(mixing_variants[i], nothing)});
  // Only the look-up, as the paper counts type 3: the inputs of eq. (6) and (7) are taken as given.
  const auto look_up = [sum = std::make_shared<double>(0)](const auto&, const MixingReading& r) {
    const int level = mixing::scheduled_level(std::abs(r.rate.x()), std::abs(r.force.x()));
    *sum += mixing::gains_of_level(level).k1;
  };
  workloads.push_back({"type3_look_up_alone", "type1 and a look-up in Table 3",
                       stepping(mixing_variants[0], look_up)});
  return workloads;
}

}  // namespace drydock::study
