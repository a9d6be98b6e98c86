#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "hil/study/ensemble.hpp"
#include "hil/study/leveling/leveling_trial.hpp"

/// The comparison of the leveling study: filters by motions by biases, each over all runs.
namespace drydock::study {

struct LevelingFilterName {
  leveling::FilterKind kind;
  std::string_view name;
};
inline constexpr std::array<LevelingFilterName, 3> leveling_filters{
    {{leveling::FilterKind::paper, "paper"},
     {leveling::FilterKind::robust, "robust"},
     {leveling::FilterKind::augmented, "augmented"}}};

/// At 30 s, degrees.
struct LevelingFigures {
  double roll_mean, pitch_mean, roll_std, pitch_std;
};

struct LevelingCase {
  std::string_view name;
  LevelingMotion motion;
  bool stationary;
  std::optional<LevelingFigures> published;  ///< chapter 4 of the paper
};
inline constexpr std::array<LevelingCase, 4> leveling_cases{
    {{"moving_s", leveling_motions::s_path, false, LevelingFigures{0.083, 0.058, 0.046, 0.019}},
     {"stationary", leveling_motions::stationary, true,
      LevelingFigures{-0.051, 0.054, 0.003, 0.004}},
     {"straight", leveling_motions::straight, false, {}},
     {"moving_rolling", leveling_motions::rolling_s_path, false, {}}}};

inline constexpr std::array leveling_biases{LevelingBiases::one_sigma, LevelingBiases::drawn};

/// One filter in one case over the runs.
struct LevelingStatistics {
  Ensemble roll{leveling_points}, pitch{leveling_points};            ///< errors, deg
  Ensemble kept_roll{leveling_points}, kept_pitch{leveling_points};  ///< without the diverged runs
  Ensemble roll_variance{leveling_points}, pitch_variance{leveling_points};
  std::vector<double> settled_s;
  double nees_sum = 0;
  std::size_t diverged = 0;

  void add(const LevelingOutcome& outcome);
  std::size_t runs() const { return roll.runs(); }
  LevelingFigures at_the_end() const;
  LevelingFigures kept_at_the_end() const;  ///< only runs that did not diverge; there must be one
  double roll_rms() const { return roll.rms(leveling_points - 1); }
  double pitch_rms() const { return pitch.rms(leveling_points - 1); }
  double nees_mean() const { return nees_sum / static_cast<double>(runs()); }
  double settled_p95_s() const;  ///< 95 % of the runs stay below half a degree from this time on
};

template <class T>
using ByFilter = std::array<T, leveling_filters.size()>;
template <class T>
using ByCase = std::array<ByFilter<T>, leveling_cases.size()>;
template <class T>
using ByBiases = std::array<ByCase<T>, leveling_biases.size()>;  ///< [biases][case][filter]

using LevelingResults = ByBiases<LevelingStatistics>;

/// Runs every filter in every case with the random numbers of one run.
ByBiases<LevelingOutcome> run_leveling_cases(std::uint64_t seed, std::size_t run);

}  // namespace drydock::study
