#include "hil/summary/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "drivers/diagnosis/finding_words.hpp"

namespace drydock::summary {
namespace {

using Value = std::optional<double>;
using rig_config::Bounds;

struct DeviceFigure {
  std::string_view name;
  double (*of)(const DeviceSummary&);
};

constexpr DeviceFigure device_figures[]{
    {"rate_hz", [](const DeviceSummary& d) { return d.rate_hz; }},
    {"messages", [](const DeviceSummary& d) { return static_cast<double>(d.messages); }},
    {"bad_checksums", [](const DeviceSummary& d) { return static_cast<double>(d.bad_checksums); }},
    {"skipped_bytes", [](const DeviceSummary& d) { return static_cast<double>(d.bytes_skipped); }},
    {"reopens", [](const DeviceSummary& d) { return static_cast<double>(d.reopens); }},
};

/// `missing` says why there may be no value, beyond the reasons of all figures.
struct EstimatorFigure {
  std::string_view name;
  Value (*of)(const EstimatorSummary&);
  const char* missing = "the estimates do not give it";
  bool needs_truth = true;
};

/// NaN: the estimates do not give the quantity.
Value if_given(double value) { return std::isnan(value) ? Value{} : Value{value}; }

Value of_attitude(const EstimatorSummary& e, double AttitudeError::*member) {
  return e.whole_run ? if_given((*e.whole_run).*member) : Value{};
}
Value of_navigation(const EstimatorSummary& e, double NavigationError::*member) {
  return e.navigation ? if_given((*e.navigation).*member) : Value{};
}
Value answer_ms(const EstimatorSummary& e) {
  return e.program ? Value{1e3 * e.program->longest_s} : Value{};
}

constexpr auto no_covariance =
    "no estimate with a truth has a covariance above 0: it gives none, or standard deviations of 0";

constexpr EstimatorFigure estimator_figures[]{
    {"estimates", [](const auto& e) { return Value{static_cast<double>(e.estimates)}; }, "", false},
    {"rejected", [](const auto& e) { return Value{static_cast<double>(e.rejected)}; }, "", false},
    {"valid_share", [](const auto& e) { return e.valid_share; }, "no estimate", false},
    {"roll_rms_deg", [](const auto& e) { return of_attitude(e, &AttitudeError::roll_rms_deg); }},
    {"pitch_rms_deg", [](const auto& e) { return of_attitude(e, &AttitudeError::pitch_rms_deg); }},
    {"heading_rms_deg",
     [](const auto& e) { return of_navigation(e, &NavigationError::heading_rms_deg); }},
    {"position_rms_m",
     [](const auto& e) { return of_navigation(e, &NavigationError::horizontal_rms_m); }},
    {"position_end_m",
     [](const auto& e) { return of_navigation(e, &NavigationError::horizontal_end_m); }},
    {"depth_rms_m", [](const auto& e) { return of_navigation(e, &NavigationError::depth_rms_m); }},
    {"velocity_rms_mps",
     [](const auto& e) { return of_navigation(e, &NavigationError::velocity_rms_mps); }},
    {"nees", [](const auto& e) { return of_attitude(e, &AttitudeError::nees_mean); },
     no_covariance},
    {"nees_position",
     [](const auto& e) { return of_navigation(e, &NavigationError::nees_position); },
     no_covariance},
    {"nis", [](const auto& e) { return e.nis; }, "no sensor's value was taken", false},
    {"estimate_rate_hz", [](const auto& e) { return e.rate_hz; }, "fewer than two estimates",
     false},
    {"settling_s", [](const auto& e) { return of_attitude(e, &AttitudeError::settling_s); },
     "the last estimate is off by more than a degree"},
    {"answer_ms", answer_ms, "it is no other program", false},
};

/// Why an estimator has no such figure.
std::string missing_text(const EstimatorFigure& figure, const EstimatorSummary& e) {
  const std::string none = "none: ";
  if (figure.name == "answer_ms") return none + figure.missing;
  if (e.program && !e.program->failure.empty() && e.estimates == 0)
    return none + "its program " + e.program->failure;
  if (e.estimates == 0) return none + "no estimate";
  if (figure.needs_truth && !e.whole_run && !e.navigation)
    return none + "no estimate has a truth to compare with";
  return none + figure.missing;
}

template <class Figures>
const auto& figure_named(const Figures& figures, const std::string& name) {
  const auto found =
      std::ranges::find_if(figures, [&](const auto& figure) { return figure.name == name; });
  if (found == std::end(figures)) throw std::logic_error("no figure is named " + name);
  return *found;
}

std::string in_words(const Bounds& bounds) {
  if (std::isinf(bounds.low)) return fmt::format("at most {}", bounds.high);
  if (std::isinf(bounds.high)) return fmt::format("at least {}", bounds.low);
  return fmt::format("{} to {}", bounds.low, bounds.high);
}

Verdict judge_state(const rig_config::ExpectConfig& expect, const Outcome& found) {
  std::string state = found.device->state;
  if (!found.other_state.empty()) state = found.other_state;
  const bool passed = state == expect.state;
  if (!passed && !found.device->last_error.empty())
    state += fmt::format(" ({})", found.device->last_error);
  return {.subject = expect.device,
          .what = "state",
          .measured = std::move(state),
          .expected = expect.state,
          .passed = passed,
          .line = expect.state_line};
}

Verdict judge_figure(const std::string& subject, const rig_config::ExpectedFigure& figure,
                     Value value, const std::string& missing) {
  return {.subject = subject,
          .what = figure.name,
          .measured = value ? fmt::format("{:.6g}", *value) : missing,
          .expected = in_words(figure.allowed),
          .passed = value && figure.allowed.hold(*value),
          .line = figure.line};
}

constexpr std::string_view findings_figure = "findings";

std::string subject_of(const rig_config::ExpectConfig& expect) {
  if (!expect.device.empty()) return expect.device;
  return expect.estimator.empty() ? "rig" : expect.estimator;
}

/// "2 (dvl: silent from 6.8 s to 15.2 s, ...)": the number, and the first of them.
std::string counted(const std::vector<diagnosis::FindingAccount>& findings) {
  if (findings.empty()) return "0";
  const auto& first = findings.front();
  return fmt::format("{} ({}: {} {}{})", findings.size(), first.device, first.cause,
                     diagnosis::when_text(first), findings.size() > 1 ? ", ..." : "");
}

Verdict judge_findings(const std::string& subject, const rig_config::ExpectedFigure& figure,
                       const Outcome& found, const std::string& missing) {
  return {
      .subject = subject,
      .what = figure.name,
      .measured = found.findings ? counted(*found.findings) : missing,
      .expected = in_words(figure.allowed),
      .passed = found.findings && figure.allowed.hold(static_cast<double>(found.findings->size())),
      .line = figure.line};
}

}  // namespace

std::vector<Verdict> judge(const rig_config::ExpectConfig& expect, const Outcome& found) {
  std::vector<Verdict> verdicts;
  const std::string nothing =
      !found.absent.empty()
          ? "none: " + found.absent
          : fmt::format("none: the run ended at {:.1f} s, {} after_s = {}", found.duration_s,
                        found.duration_s < expect.after_s ? "before" : "with", expect.after_s);
  const std::string subject = subject_of(expect);
  if (!expect.state.empty()) {
    verdicts.push_back(
        found.device ? judge_state(expect, found)
                     : Verdict{subject, "state", nothing, expect.state, false, expect.state_line});
  }
  for (const auto& figure : expect.figures) {
    Value value;
    std::string missing = nothing;
    if (figure.name == findings_figure) {
      verdicts.push_back(judge_findings(subject, figure, found, missing));
      continue;
    }
    if (!expect.device.empty()) {
      const auto& known = figure_named(device_figures, figure.name);
      if (found.device) value = known.of(*found.device);
    } else {
      const auto& known = figure_named(estimator_figures, figure.name);
      if (found.estimator) {
        value = known.of(*found.estimator);
        missing = missing_text(known, *found.estimator);
      }
    }
    verdicts.push_back(judge_figure(subject, figure, value, missing));
  }
  return verdicts;
}

std::string to_text(const std::vector<Verdict>& verdicts) {
  if (verdicts.empty()) return {};
  std::string out;
  for (const auto& v : verdicts) {
    out += fmt::format("{} {} {}: {}, expected {}\n", v.passed ? "PASS" : "FAIL", v.subject, v.what,
                       v.measured, v.expected);
  }
  return out + fmt::format("{} of {} expectations met\n",
                           std::ranges::count(verdicts, true, &Verdict::passed), verdicts.size());
}

}  // namespace drydock::summary
