#include "hil/study/leveling/leveling_statistics.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::study {

namespace {

LevelingFigures last_of(const Ensemble& roll, const Ensemble& pitch) {
  constexpr std::size_t end = leveling_points - 1;
  return {roll.mean(end), pitch.mean(end), roll.deviation(end), pitch.deviation(end)};
}

}  // namespace

void LevelingStatistics::add(const LevelingOutcome& outcome) {
  roll.add(outcome.roll_error);
  pitch.add(outcome.pitch_error);
  roll_variance.add(outcome.roll_variance);
  pitch_variance.add(outcome.pitch_variance);
  settled_s.push_back(outcome.settled_s);
  nees_sum += outcome.nees;
  if (outcome.diverged) {
    ++diverged;
  } else {
    kept_roll.add(outcome.roll_error);
    kept_pitch.add(outcome.pitch_error);
  }
}

LevelingFigures LevelingStatistics::at_the_end() const { return last_of(roll, pitch); }

LevelingFigures LevelingStatistics::kept_at_the_end() const {
  return last_of(kept_roll, kept_pitch);
}

double LevelingStatistics::settled_p95_s() const {
  auto sorted = settled_s;
  std::ranges::sort(sorted);
  const auto rank = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(sorted.size())));
  return sorted.at(rank - 1);
}

ByBiases<LevelingOutcome> run_leveling_cases(std::uint64_t seed, std::size_t run) {
  ByBiases<LevelingOutcome> outcomes;
  for (std::size_t b = 0; b < leveling_biases.size(); ++b) {
    for (std::size_t c = 0; c < leveling_cases.size(); ++c) {
      const auto& which = leveling_cases[c];
      const LevelingTrial trial{which.motion, which.stationary, leveling_biases[b], seed, run};
      const auto readings = leveling_readings(trial);
      for (std::size_t f = 0; f < leveling_filters.size(); ++f) {
        const auto kind = leveling_filters[f].kind;
        outcomes[b][c][f] = run_leveling(trial, readings, kind, leveling::options_for(kind));
      }
    }
  }
  return outcomes;
}

}  // namespace drydock::study
