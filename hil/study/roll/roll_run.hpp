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

/// The paper's two methods with their own gyro biases, the first also with the larger bias, and our
/// method.
inline constexpr std::array roll_methods{
    RollMethod{"paper", 0.1}, RollMethod{"paper_bias_0.5", 0.5}, RollMethod{"paper_with_bias", 0.5},
    RollMethod{"all_satellites", 0.5}};

/// The filter options of the study. They use only what a data sheet says about the sensors.
roll::PeakFilterOptions peak_options(bool with_bias);
roll::AllSatellitesOptions all_satellites_options(const RollCase& the_case);

/// The errors of one method in one flight, degrees. They count from roll_settled_s on, unless
/// noted.
struct RollErrors {
  double rms = 0;
  double nees = 0;               ///< mean
  double convergence_s = 0;      ///< from the start: first time within 5 deg for 2 s
  std::vector<float> absolute;   ///< some of the errors at 100 Hz
  std::vector<float> at_epochs;  ///< signed, from the start; NaN before the first estimate
};

struct RollOutcome {
  std::array<RollErrors, roll_methods.size()> errors;
  std::vector<float> raw;     ///< single peaks, absolute, from the start
  std::vector<double> bound;  ///< smallest variance after each epoch, rad2
  double witness_rms = 0;     ///< RollWitness for all_satellites, degrees
};

/// Called after each epoch, for drawing.
class RollObserver {
 public:
  virtual ~RollObserver() = default;
  virtual void on_epoch(double t, std::span<const roll::Signal> signals,
                        const roll::PeakFilter& paper, double true_roll) = 0;
};

RollOutcome roll_run(const RollCase& the_case, const RollSky& sky, std::uint64_t seed,
                     std::size_t run, RollObserver* observer = nullptr);

}  // namespace drydock::study
