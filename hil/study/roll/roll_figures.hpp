#pragma once

#include <vector>

#include "hil/study/figure.hpp"
#include "hil/study/roll/roll_run.hpp"

namespace drydock::study {

/// The paper's Fig. 4 to 9 again, with the first flight of a case.
std::vector<Figure> roll_figures(const RollCase& the_case, const RollSky& sky, std::uint64_t seed);

/// Error over time, root mean square over the runs, of every method, beside the bound.
class RollEnsemble {
 public:
  void add(const RollOutcome& outcome);
  Figure figure() const;

 private:
  std::vector<std::vector<double>> squares_;  ///< of each method, and last the bound's
  double runs_ = 0;
};

}  // namespace drydock::study
