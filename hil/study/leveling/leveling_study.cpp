#include "hil/study/leveling/leveling_study.hpp"

#include <fmt/format.h>

#include <memory>

namespace drydock::study {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const LevelingStatistics& s) {
  const auto end = s.at_the_end();
  return {{"roll_mean_deg", end.roll_mean},    {"pitch_mean_deg", end.pitch_mean},
          {"roll_std_deg", end.roll_std},      {"pitch_std_deg", end.pitch_std},
          {"roll_rms_deg", s.roll_rms()},      {"pitch_rms_deg", s.pitch_rms()},
          {"diverged_runs", s.diverged},       {"nees_mean", s.nees_mean()},
          {"settled_p95_s", s.settled_p95_s()}};
}

/// filter -> case -> figures
Json json_of(const ByCase<LevelingStatistics>& results) {
  Json json;
  for (std::size_t f = 0; f < leveling_filters.size(); ++f)
    for (std::size_t c = 0; c < leveling_cases.size(); ++c)
      json[std::string(leveling_filters[f].name)][std::string(leveling_cases[c].name)] =
          json_of(results[c][f]);
  return json;
}

Json published() {
  Json json;
  for (const auto& which : leveling_cases)
    if (const auto& p = which.published)
      json[std::string(which.name)] = {{"roll_mean_deg", p->roll_mean},
                                       {"pitch_mean_deg", p->pitch_mean},
                                       {"roll_std_deg", p->roll_std},
                                       {"pitch_std_deg", p->pitch_std}};
  return json;
}

/// The first cells of a row: mean and deviation with this number of decimals.
std::vector<std::string> figures_row(const LevelingCase& which, std::string filter,
                                     const LevelingFigures& figures, int decimals) {
  const auto cell = [&](double deg) { return fmt::format("{:.{}f}", deg, decimals); };
  const auto with_sign = [&](double deg) { return fmt::format("{:+.{}f}", deg, decimals); };
  return {std::string(which.name),       std::move(filter),      with_sign(figures.roll_mean),
          with_sign(figures.pitch_mean), cell(figures.roll_std), cell(figures.pitch_std)};
}

std::vector<std::string> published_row(const LevelingCase& which) {
  auto row = figures_row(which, "as published", *which.published, 3);
  row.insert(row.end(), {"", "", "not said", "", ""});
  return row;
}

std::vector<std::string> our_row(const LevelingCase& which, std::string_view filter,
                                 const LevelingStatistics& s) {
  auto row = figures_row(which, std::string(filter), s.at_the_end(), 4);
  const bool settles = s.settled_p95_s() < leveling_duration_s;
  row.insert(row.end(),
             {fmt::format("{:.4f}", s.roll_rms()), fmt::format("{:.4f}", s.pitch_rms()),
              fmt::format("{} of {}", s.diverged, s.runs()), fmt::format("{:.3g}", s.nees_mean()),
              settles ? fmt::format("{:.1f}", s.settled_p95_s()) : "no"});
  return row;
}

std::vector<std::string> kept_row(const LevelingCase& which, std::string_view filter,
                                  const LevelingStatistics& s) {
  auto row = figures_row(which, fmt::format("{}, kept runs", filter), s.kept_at_the_end(), 4);
  row.insert(row.end(), {"", "", "", "", ""});
  return row;
}

report::Table table_of(const ByCase<LevelingStatistics>& results, std::string title,
                       std::string note) {
  report::Table table{std::move(title),
                      {"motion", "filter", "roll mean", "pitch mean", "roll std", "pitch std",
                       "roll RMS", "pitch RMS", "lost", "NEES", "< 0.5 deg [s]"},
                      {},
                      std::move(note)};
  for (std::size_t c = 0; c < leveling_cases.size(); ++c) {
    const auto& which = leveling_cases[c];
    if (which.published) table.rows.push_back(published_row(which));
    for (std::size_t f = 0; f < leveling_filters.size(); ++f) {
      const auto& s = results[c][f];
      table.rows.push_back(our_row(which, leveling_filters[f].name, s));
      if (s.diverged > 0 && s.diverged < s.runs())
        table.rows.push_back(kept_row(which, leveling_filters[f].name, s));
    }
  }
  return table;
}

}  // namespace

std::vector<report::Table> leveling_tables(const LevelingResults& results) {
  return {table_of(results[0], "Errors at 30 s [deg], every bias of Table 1 at +1 sigma",
                   "lost: an error beyond 5 deg at 30 s; kept: not lost. NEES: of roll and pitch, "
                   "per state; 1 is "
                   "consistent. < 0.5 deg: from there on, in 95 % of the runs."),
          table_of(results[1], "Errors at 30 s [deg], biases drawn for each run", "")};
}

Result leveling_study(const Options& options, Progress& progress) {
  const auto results = std::make_unique<LevelingResults>();
  Result result;
  result.runs = campaign(
      "leveling", options, progress,
      [&](std::size_t run) { return run_leveling_cases(options.seed, run); },
      [&](std::size_t, const ByBiases<LevelingOutcome>& outcome) {
        for (std::size_t b = 0; b < leveling_biases.size(); ++b)
          for (std::size_t c = 0; c < leveling_cases.size(); ++c)
            for (std::size_t f = 0; f < leveling_filters.size(); ++f)
              (*results)[b][c][f].add(outcome[b][c][f]);
      });
  if (result.runs == 0) return result;
  result.tables = leveling_tables(*results);
  result.figures = leveling_figures(*results);
  result.json = json_of((*results)[0]);
  result.json["drawn_biases"] = json_of((*results)[1]);
  result.json["published"] = published();
  return result;
}

}  // namespace drydock::study
