#pragma once

#include <vector>

#include "hil/study/roll/roll_case.hpp"

namespace drydock::study {

/// Posterior Cramer-Rao bound (Tichavsky, Muravchik, Nehorai 1998) of one flight: the smallest
/// variance of roll, rad2, that any unbiased estimator can have after each epoch. The estimator
/// knows the gyro's noise, and the priors of the bias and of the gains that vary. At first it knows
/// nothing about the roll. docs/estimators/roll.md eq. (34) to (36).
std::vector<double> roll_bound(const RollCase& the_case, const RollFlight& flight,
                               double bias_sigma_radps, double bias_noise);

/// Fisher information of one power about its expected value. The power is rounded to whole dB
/// relative to boresight and is lost below roll_tracking_limit, eq. (36). Without rounding it is 1
/// / sigma^2.
double rounded_information(double expected, double sigma);

}  // namespace drydock::study
