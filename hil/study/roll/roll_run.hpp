#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "estimators/roll/all_satellites.hpp"
#include "estimators/roll/peak_filter.hpp"
#include "hil/study/roll/roll_case.hpp"

namespace drydock::study {

struct RollMethod {
  std::string_view name;
  double gyro_bias_degps;
};

/// The paper's two with the biases they are asked to bear; and the first with the larger one.
inline constexpr std::array roll_methods{
    RollMethod{"paper", 0.1}, RollMethod{"paper_bias_0.5", 0.5}, RollMethod{"paper_with_bias", 0.5},
    RollMethod{"all_satellites", 0.5}};

/// The filters as the study has them: what a data sheet says of the case's sensors, no more.
roll::PeakFilterOptions peak_options(bool with_bias);
roll::AllSatellitesOptions all_satellites_options(const RollCase& the_case);

/// Of one method in one flight, degrees; from roll_settled_s on unless it says otherwise.
struct RollErrors {
  double rms = 0;
  double nees = 0;               ///< mean
  double convergence_s = 0;      ///< from the start: first time within 5 deg for 2 s
  std::vector<float> absolute;   ///< some of the errors at 100 Hz
  std::vector<float> at_epochs;  ///< with sign, from the start; NaN before the first estimate
};

struct RollOutcome {
  std::array<RollErrors, roll_methods.size()> errors;
  std::vector<float> raw;     ///< of single peaks, absolute, from the start
  std::vector<double> bound;  ///< least variance after each epoch, rad2
  double witness_rms = 0;     ///< of RollWitness beside all_satellites, degrees
};

/// One more epoch has been worked in; for who draws it.
class RollObserver {
 public:
  virtual ~RollObserver() = default;
  virtual void on_epoch(double t, std::span<const roll::Signal> signals,
                        const roll::PeakFilter& paper, double true_roll) = 0;
};

RollOutcome roll_run(const RollCase& the_case, const RollSky& sky, std::uint64_t seed,
                     std::size_t run, RollObserver* observer = nullptr);

}  // namespace drydock::study
