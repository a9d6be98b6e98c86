#include "drivers/diagnosis/verdict.hpp"

#include <algorithm>
#include <array>

namespace drydock::diagnosis {
namespace {

/// A rule fires if its sign is present. The first rule that fires decides: what hides others comes
/// first.
struct Rule {
  Sign sign;
  Cause cause;
  double confidence;
};

constexpr auto rules = std::to_array<Rule>({
    {Sign::port_lost, Cause::port_lost, 0.95},
    {Sign::nothing_decodes, Cause::wrong_baud, 0.9},
    {Sign::error_frames, Cause::error_frames, 0.9},
    {Sign::bad_checksums, Cause::damaged, 0.9},
    {Sign::silent, Cause::silent, 0.9},
    {Sign::foreign_bytes, Cause::foreign_bytes, 0.8},
    {Sign::stuck, Cause::stuck, 0.8},
    {Sign::delayed, Cause::delay, 0.7},
    {Sign::rotated, Cause::mounting, 0.7},
    {Sign::scale, Cause::scale, 0.7},
    {Sign::ramp, Cause::drift, 0.7},
    {Sign::offset, Cause::bias, 0.7},
    {Sign::step, Cause::bias, 0.6},
});

}  // namespace

std::optional<Verdict> verdict_on(std::span<const Symptom> signs) {
  for (const Rule& rule : rules)
    if (std::ranges::find(signs, rule.sign, &Symptom::sign) != signs.end())
      return Verdict{rule.cause, rule.confidence};
  return {};
}

}  // namespace drydock::diagnosis
