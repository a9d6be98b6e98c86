#pragma once

#include <vector>

#include "hil/report/figure.hpp"
#include "hil/study/roll/roll_run.hpp"

namespace drydock::study {

/// The paper's Fig. 4 to 9, with the first flight of a case.
std::vector<report::Figure> roll_figures(const RollCase& the_case, const RollSky& sky,
                                         std::uint64_t seed);

/// The root mean square error over the runs against time, for every method, with the bound.
class RollEnsemble {
 public:
  void add(const RollOutcome& outcome);
  report::Figure figure() const;

 private:
  std::vector<std::vector<double>> squares_;  ///< one per method; the last is the bound
  double runs_ = 0;
};

}  // namespace drydock::study
