#include "drivers/diagnosis/verdict.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace drydock::diagnosis {
namespace {

/// A rule fires if its sign is present with at least that value, together with the other sign where
/// it names one. The first rule that fires decides: what hides others comes first.
struct Rule {
  Sign sign;
  Cause cause;
  double confidence;
  std::optional<Sign> with = {};
  double least = -std::numeric_limits<double>::infinity();
};

/// A shorter silence may be a pause of a line that holds messages, seconds.
constexpr double long_silence = 3;

constexpr auto rules = std::to_array<Rule>({
    // the line and the bus
    {Sign::port_lost, Cause::port_lost, 0.95},
    {Sign::bus_off, Cause::bus_off, 0.95},
    {Sign::heat, Cause::hot, 0.95},
    {Sign::nothing_decodes, Cause::wrong_baud, 0.9},
    {Sign::prompts, Cause::foreign_bytes, 0.9},
    {Sign::bus_taken, Cause::bus_load, 0.9},
    {Sign::error_frames, Cause::error_frames, 0.9},
    {Sign::silent, Cause::silent, 0.9, {}, long_silence},
    {Sign::address_taken, Cause::address_stolen, 0.95},
    {Sign::bad_checksums, Cause::damaged, 0.9},
    {Sign::strange_frames, Cause::foreign_bytes, 0.8},
    {Sign::foreign_bytes, Cause::damaged, 0.7, Sign::gaps},
    {Sign::foreign_bytes, Cause::foreign_bytes, 0.8},
    {Sign::impossible, Cause::damaged, 0.8},
    {Sign::wild_unequal, Cause::damaged, 0.8, Sign::gaps},
    // time
    {Sign::bunched, Cause::burst, 0.9},
    {Sign::repeated, Cause::duplicate, 0.9},
    {Sign::rate_low, Cause::slow, 0.9},
    {Sign::time_backwards, Cause::reorder, 0.9},
    {Sign::irregular, Cause::jitter, 0.8},
    {Sign::swapped, Cause::reorder, 0.6},
    {Sign::silent, Cause::silent, 0.8},
    {Sign::late, Cause::delay, 0.7},
    {Sign::delayed, Cause::delay, 0.8},
    {Sign::clock_step, Cause::clock_step, 0.9},
    {Sign::gaps, Cause::drop, 0.9},
    {Sign::rate_unexpected, Cause::line_full, 0.9, Sign::line_full},
    {Sign::rate_unexpected, Cause::wrong_rate, 0.8},
    // values
    {Sign::values_missing, Cause::bottom_lost, 0.9},
    {Sign::signals_changed, Cause::antenna_gain, 0.8},
    {Sign::satellites_gone, Cause::satellites_blocked, 0.9},
    {Sign::coarse, Cause::coarse, 0.9},
    {Sign::noisy, Cause::noise, 0.8},
    {Sign::wild_unequal, Cause::damaged, 0.7},
    {Sign::wild_samples, Cause::spike, 0.8},
    {Sign::out_of_range, Cause::bias, 0.7},
    {Sign::stuck, Cause::stuck, 0.9},
    // against other sensors
    {Sign::rotated, Cause::mounting, 0.8},
    {Sign::scale, Cause::scale, 0.8},
    {Sign::step, Cause::bias, 0.6},
    {Sign::ramp, Cause::drift, 0.8},
    {Sign::offset, Cause::bias, 0.8},
    {Sign::clock_drift, Cause::clock_drift, 0.8},
    {Sign::refuses, Cause::nak, 0.9},
    {Sign::error_report, Cause::device_error, 0.9},
});

constexpr std::uint64_t bit_of(Sign sign) {
  return std::uint64_t{1} << static_cast<unsigned>(sign);
}

const Symptom* find_sign(std::span<const Symptom> signs, Sign sign) {
  const auto found = std::ranges::find(signs, sign, &Symptom::sign);
  return found != signs.end() ? &*found : nullptr;
}

}  // namespace

std::optional<Verdict> verdict_on(std::span<const Symptom> signs) {
  std::uint64_t present = 0;
  for (const Symptom& symptom : signs) present |= bit_of(symptom.sign);
  for (const Rule& rule : rules) {
    if ((present & bit_of(rule.sign)) == 0) continue;
    if (find_sign(signs, rule.sign)->value < rule.least) continue;
    if (rule.with && (present & bit_of(*rule.with)) == 0) continue;
    return Verdict{rule.cause, rule.confidence, rule.sign};
  }
  return {};
}

}  // namespace drydock::diagnosis
