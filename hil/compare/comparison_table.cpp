#include "hil/compare/comparison_table.hpp"

#include <fmt/format.h>

#include <limits>

#include "hil/summary/or_none.hpp"

namespace drydock::compare {
namespace {

using summary::or_none;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// NEES of the position where there is one, else that of the attitude.
double nees_of(const summary::EstimatorSummary& s) {
  if (s.navigation) return s.navigation->nees_position;
  return s.whole_run ? s.whole_run->nees_mean : none;
}

void add_errors(const summary::EstimatorSummary& s, std::vector<std::string>& row) {
  const auto& a = s.whole_run;
  const auto& n = s.navigation;
  row.push_back(or_none(a ? a->roll_rms_deg : none, 3));
  row.push_back(or_none(a ? a->roll_max_deg : none, 3));
  row.push_back(or_none(a ? a->pitch_rms_deg : none, 3));
  row.push_back(or_none(a ? a->pitch_max_deg : none, 3));
  row.push_back(or_none(n ? n->horizontal_rms_m : none, 2));
  row.push_back(or_none(n ? n->horizontal_max_m : none, 2));
  row.push_back(or_none(n ? n->velocity_rms_mps : none, 4));
  row.push_back(or_none(nees_of(s), 2));
}

std::vector<std::string> row_of(const Entry& entry, bool truth) {
  const auto& s = entry.summary;
  std::vector<std::string> row{entry.choice, fmt::format("{}", s.estimates)};
  if (truth) add_errors(s, row);
  row.push_back(or_none(s.nis.value_or(none), 2));
  row.push_back(fmt::format("{}", s.rejected));
  row.push_back(s.valid_share ? fmt::format("{:.1f}", 100 * *s.valid_share) : "none");
  row.push_back(fmt::format("{}", entry.gaps.count));
  row.push_back(fmt::format("{:.2f}", entry.gaps.longest_s));
  row.push_back(or_none(entry.cost_us(), 2));
  return row;
}

}  // namespace

report::Table table_of(const Comparison& comparison) {
  report::Table table;
  table.title = fmt::format("{}: {} measurements in {:.1f} s", comparison.source,
                            comparison.measurements, comparison.duration_s);
  table.columns = {"estimator", "estimates"};
  const std::vector<std::string> errors{"roll RMS [deg]",   "max", "pitch RMS [deg]",    "max",
                                        "position RMS [m]", "max", "velocity RMS [m/s]", "NEES"};
  if (comparison.truth) table.columns.insert(table.columns.end(), errors.begin(), errors.end());
  for (const char* column : {"NIS", "rejected", "valid [%]", "gaps", "longest [s]", "cost [us]"})
    table.columns.emplace_back(column);
  for (const auto& entry : comparison.entries)
    table.rows.push_back(row_of(entry, comparison.truth));
  table.note =
      "NEES and NIS: 1 is consistent. A gap is more than three times the median time between valid "
      "estimates. Cost: processor time for each measurement that the estimator used.";
  return table;
}

std::vector<std::string> notes_of(const Comparison& comparison) {
  auto notes = comparison.notes;
  if (!comparison.truth) notes.emplace_back("no truth: no errors are known");
  for (const auto& entry : comparison.entries) {
    if (entry.summary.estimates == 0)
      notes.push_back(fmt::format(
          "{}: no estimate; it used {} of {} measurements: look which of its inputs is missing",
          entry.choice, entry.used, comparison.measurements));
    for (const auto& note : entry.notes) notes.push_back(entry.choice + ": " + note);
    if (const auto& program = entry.summary.program)
      notes.push_back(fmt::format(
          "{}: its cost is that of waiting here; its program answered after {:.2f} ms on average",
          entry.choice, 1e3 * program->mean_s));
  }
  return notes;
}

}  // namespace drydock::compare
