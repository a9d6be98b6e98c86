#pragma once

#include <vector>

#include "hil/study/roll/roll_case.hpp"

namespace drydock::study {

/// Posterior Cramer-Rao bound (Tichavsky, Muravchik, Nehorai 1998) of one flight: the least
/// variance of roll, rad2, that any unbiased estimator can have after each epoch, knowing the
/// gyro's noise, the priors of bias and of those gains that really differ, and nothing of the roll
/// at first. docs/estimators/roll.md eq. (34) to (36).
std::vector<double> roll_bound(const RollCase& the_case, const RollFlight& flight,
                               double bias_sigma_radps, double bias_noise);

/// Fisher information of one power about its expected value when it is rounded to whole dB of
/// boresight and lost below roll_tracking_limit, eq. (36). Unrounded it would be 1 / sigma^2.
double rounded_information(double expected, double sigma);

}  // namespace drydock::study
