#pragma once

#include <array>
#include <chrono>
#include <optional>

#include "estimators/navigation/constraint_mean.hpp"
#include "estimators/navigation/innovation.hpp"
#include "estimators/navigation/innovation_window.hpp"
#include "estimators/pipeline/trust.hpp"

namespace drydock::pipeline {

/// Two sources that tell the same thing: whether they agree. Times are valid_at. "When sensors
/// contradict" of docs/estimators/dead-reckoning.md.
class PairWatch {
 public:
  /// Two that have contradicted each other for this long without a pause go on doing so.
  static constexpr std::chrono::seconds lasts_after{10};

  void add(const navigation::Innovations& rows, measurement::Stamp at);

  /// False from a comparison beyond the gate until one within it, and for 5 s after rows that
  /// contradict; what was compared too long ago says nothing.
  bool agrees(measurement::Stamp now) const;
  /// The rows contradict, each by itself or in the mean.
  bool contradicts() const;
  /// They have for so long that it will last.
  bool lasts(measurement::Stamp now) const { return trust_.doubted(now) >= lasts_after; }
  /// What lasts is known: it starts to judge again.
  void begin_anew();

 private:
  static constexpr double brief_comparisons = 2;
  /// Rows of the last ten comparisons, and of the last two or three: what grows is seen early.
  std::array<navigation::InnovationWindow, 3> windows_;
  std::array<navigation::ConstraintMean, 3> brief_{navigation::ConstraintMean(brief_comparisons),
                                                   navigation::ConstraintMean(brief_comparisons),
                                                   navigation::ConstraintMean(brief_comparisons)};
  Trust trust_;
  std::optional<measurement::Stamp> outside_at_;  ///< of the last comparison, if beyond the gate
};

}  // namespace drydock::pipeline
