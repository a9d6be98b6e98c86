#include "hil/calibrate/outcome_words.hpp"

#include <fmt/format.h>

#include "drivers/measurement/units.hpp"

namespace drydock::calibrate {

using calibration::Finding;
using calibration::Verdict;

namespace {

bool is_angle(const Finding& finding) { return unit_of(finding.parameter.unknown) == "rad"; }

}  // namespace

double shown(const Finding& finding, double value) {
  return is_angle(finding) ? value * units::degrees_per_radian : value;
}

std::string shown_unit(const Finding& finding) {
  const auto unit = unit_of(finding.parameter.unknown);
  return is_angle(finding) ? "deg" : unit == "1" ? "" : std::string(unit);
}

std::string full_name(const Outcome& outcome, const Finding& finding) {
  return outcome.gathered.device_name(finding.parameter.device) + ": " +
         std::string(name_of(finding.parameter.unknown));
}

std::string_view verdict_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::told: return "told";
    case Verdict::weakly: return "told weakly";
    case Verdict::not_told: break;
  }
  return "not told";
}

std::string why_of(const Outcome& outcome, const Finding& finding) {
  if (finding.verdict == Verdict::told || finding.confused_with < 0) return finding.why;
  const auto& all = outcome.calibration.findings;
  return "it cannot be told apart from " +
         full_name(outcome, all.at(static_cast<std::size_t>(finding.confused_with)));
}

std::string settled_text(const calibration::Calibration& calibration) {
  return calibration.converged ? fmt::format("settled after {} iterations", calibration.iterations)
                               : fmt::format("did not settle within {} iterations: nothing is told",
                                             calibration.iterations);
}

}  // namespace drydock::calibrate
