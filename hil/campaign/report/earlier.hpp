#pragma once

#include <string>
#include <vector>

#include "hil/campaign/report/results.hpp"
#include "hil/campaign/statistics/comparison.hpp"

namespace drydock::campaign {

enum class Verdict : std::uint8_t { better, worse, same, undecided };

/// A figure of this campaign beside that of an earlier one. A verdict is wrong with a probability
/// of at most 1 - confidence.
struct FigureShift {
  std::string figure;
  bool paired = false;  ///< runs of equal values and seed are compared with each other
  std::size_t earlier = 0, later = 0;  ///< how many runs have the figure
  Shift shift;                         ///< in badness(): above 0 is worse
  Verdict verdict = Verdict::undecided;
};

/// The figures that both have by name, in the order of the later one.
std::vector<FigureShift> shifts_since(const Results& earlier, const Results& later);

const char* to_text(Verdict verdict);

}  // namespace drydock::campaign
