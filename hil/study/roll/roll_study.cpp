#include "hil/study/roll/roll_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "drivers/measurement/units.hpp"
#include "hil/study/roll/roll_figures.hpp"
#include "hil/study/roll/roll_run.hpp"

namespace drydock::study {
namespace {

/// No archive at hand has the paper's day, 2013-12-05. This day has the same constellation without
/// two satellites.
constexpr const char* default_ephemeris = "../shared/corpora/gnss/brdc1820.10n";

constexpr std::array cases{RollCase{.name = "ideal"},
                           RollCase{.name = "wire", .wire = true},
                           RollCase{.name = "ideal_2hz", .roll_hz = 2},
                           RollCase{.name = "wire_2hz", .roll_hz = 2, .wire = true},
                           RollCase{.name = "everything",
                                    .wire = true,
                                    .gain_sigma = 0.2,
                                    .satellite_gain_sigma = 0.1,
                                    .gyro_white_degps = 1},
                           RollCase{.name = "everything_2hz",
                                    .roll_hz = 2,
                                    .wire = true,
                                    .gain_sigma = 0.2,
                                    .satellite_gain_sigma = 0.1,
                                    .gyro_white_degps = 1}};

using OneRun = std::array<RollOutcome, cases.size()>;

template <class T>
double percentile_95(std::vector<T> values) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * 95 / 100);
  std::nth_element(values.begin(), at, values.end());
  return static_cast<double>(*at);
}

/// Sums over the runs of one case and method.
class MethodSum {
 public:
  void add(const RollErrors& errors) {
    ++runs_;
    squares_ += errors.rms * errors.rms;
    nees_ += errors.nees;
    worst_ = std::max(worst_, errors.rms);
    absolute_.insert(absolute_.end(), errors.absolute.begin(), errors.absolute.end());
    convergence_.push_back(errors.convergence_s);
  }
  double rms() const { return std::sqrt(squares_ / runs_); }
  double p95() const { return percentile_95(absolute_); }
  double worst() const { return worst_; }
  double convergence_p95() const { return percentile_95(convergence_); }
  double nees() const { return nees_ / runs_; }

 private:
  double runs_ = 0, squares_ = 0, nees_ = 0, worst_ = 0;
  std::vector<float> absolute_;
  std::vector<double> convergence_;
};

/// Sums over the runs of one case.
struct CaseSum {
  std::array<MethodSum, roll_methods.size()> methods;
  std::vector<float> raw;
  double variances = 0, instants = 0;  ///< the bound, after the filters have settled
  double witness_squares = 0, witness_worst = 0, runs = 0;

  void add(const RollOutcome& outcome) {
    for (std::size_t m = 0; m < methods.size(); ++m) methods[m].add(outcome.errors[m]);
    raw.insert(raw.end(), outcome.raw.begin(), outcome.raw.end());
    witness_squares += outcome.witness_rms * outcome.witness_rms;
    witness_worst = std::max(witness_worst, outcome.witness_rms);
    ++runs;
    for (std::size_t i = outcome.bound.size() / 5; i < outcome.bound.size(); ++i) {
      variances += outcome.bound[i];
      ++instants;
    }
  }
  double bound_deg() const { return std::sqrt(variances / instants) * units::degrees_per_radian; }
  double witness_rms() const { return std::sqrt(witness_squares / runs); }
};
static_assert(5 * roll_settled_s == roll_run_s, "CaseSum::add begins at a fifth");

std::string existing(const std::string& asked) {
  std::string file = asked.empty() ? default_ephemeris : asked;
  if (std::filesystem::is_regular_file(file)) return file;
  throw std::runtime_error(fmt::format(
      "study roll: no GPS navigation file {}; allowed: --ephemeris FILE, a RINEX 2 or 3 broadcast "
      "file such as brdc1820.10n of 2010-07-01",
      file));
}

nlohmann::ordered_json figures_of(const CaseSum& sum, std::size_t m) {
  const auto& method = sum.methods[m];
  return {{"gyro_bias_degps", roll_methods[m].gyro_bias_degps},
          {"raw_p95_deg", percentile_95(sum.raw)},
          {"rms_deg", method.rms()},
          {"p95_deg", method.p95()},
          {"worst_run_rms_deg", method.worst()},
          {"convergence_p95_s", method.convergence_p95()},
          {"nees_mean", method.nees()},
          {"bound_deg", sum.bound_deg()},
          {"rms_over_bound", method.rms() / sum.bound_deg()},
          {"efficient_rms_deg", sum.witness_rms()},
          {"efficient_worst_run_rms_deg", sum.witness_worst}};
}

report::Table table_of(const std::array<CaseSum, cases.size()>& sums) {
  report::Table table;
  table.title = "Roll error after 20 s, degrees (convergence in s)";
  table.columns = {"case, method",   "gyro bias", "raw p95", "RMS",       "p95",       "worst run",
                   "converged 95 %", "NEES",      "bound",   "RMS/bound", "efficient", "its worst"};
  table.rows.push_back({"the paper, 0.25 Hz", "none", "20", "2", "", "", "", "", "", "", "", ""});
  for (std::size_t c = 0; c < cases.size(); ++c)
    for (std::size_t m = 0; m < roll_methods.size(); ++m) {
      const auto& method = sums[c].methods[m];
      const auto with = [](const char* format, double x) {
        return fmt::format(fmt::runtime(format), x);
      };
      table.rows.push_back(
          {fmt::format("{}, {}", cases[c].name, roll_methods[m].name),
           with("{:.1f}", roll_methods[m].gyro_bias_degps),
           with("{:.1f}", percentile_95(sums[c].raw)), with("{:.3f}", method.rms()),
           with("{:.2f}", method.p95()), with("{:.2f}", method.worst()),
           with("{:.2f}", method.convergence_p95()), with("{:.2f}", method.nees()),
           with("{:.3f}", sums[c].bound_deg()), with("{:.2f}", method.rms() / sums[c].bound_deg()),
           with("{:.3f}", sums[c].witness_rms()), with("{:.2f}", sums[c].witness_worst)});
    }
  table.note =
      "ideal: powers as received. wire: C/N0 in whole dB, directions in whole degrees, satellites "
      "below -20 dB lost. everything: that, and gains off by 20 % in common and 10 % each, gyro "
      "noise 1 deg/s a sample. Bound: posterior Cramer-Rao, bias prior 1 deg/s. Efficient: what a "
      "filter linearised at the truth makes of the noises of all_satellites. The paper's "
      "ephemeris of 2013-12-05 is not to be had.";
  return table;
}

}  // namespace

Result run_roll_study(const Options& options, Progress& progress) {
  const auto skies = roll_skies(existing(options.ephemeris));
  std::array<CaseSum, cases.size()> sums;
  RollEnsemble over_time;
  Result result;
  result.runs = campaign(
      "roll", options, progress,
      [&](std::size_t k) {
        OneRun run;
        for (std::size_t c = 0; c < cases.size(); ++c)
          run[c] = roll_run(cases[c], skies[k % skies.size()], options.seed, k);
        return run;
      },
      [&](std::size_t, const OneRun& run) {
        for (std::size_t c = 0; c < cases.size(); ++c) sums[c].add(run[c]);
        over_time.add(run.front());
      });
  if (result.runs == 0) return result;

  result.tables = {table_of(sums)};
  for (std::size_t m = 0; m < roll_methods.size(); ++m)
    for (std::size_t c = 0; c < cases.size(); ++c)
      result.json[std::string(roll_methods[m].name)][std::string(cases[c].name)] =
          figures_of(sums[c], m);
  result.figures = roll_figures(cases.front(), skies.front(), options.seed);
  result.figures.push_back(over_time.figure());
  return result;
}

}  // namespace drydock::study
