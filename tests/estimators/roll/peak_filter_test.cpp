#include "estimators/roll/peak_filter.hpp"

#include <gtest/gtest.h>

#include "tests/estimators/roll/flight.hpp"

namespace drydock::roll::peak_filter_test {
namespace {

using test::degree;
using test::Flight;

constexpr double gyro_dt = 0.01, to_deg = 1 / degree;

/// Flies with a gyro of this bias. Returns the error at the end, degrees; `raw` gets the error of
/// each peak.
double fly(PeakFilter& filter, Flight flight, double seconds, double bias_radps,
           std::vector<double>* raw = nullptr) {
  const int samples = static_cast<int>(seconds / gyro_dt);
  for (int k = 1; k <= samples; ++k) {
    const double t = k * gyro_dt;
    filter.predict(flight.rate_radps + bias_radps, gyro_dt);
    if (k % 10 != 0) continue;
    filter.update({.signals = flight.at(t), .path = flight.path()});
    if (!raw) continue;
    for (const auto& peak : filter.peaks())
      raw->push_back(frame::wrap_pi(peak.roll_rad - flight.roll(peak.time_s)) * to_deg);
  }
  return frame::wrap_pi(filter.roll() - flight.roll(seconds)) * to_deg;
}

TEST(PeakFilter, WithoutNoiseEveryPeakIsDatedToAFractionOfAnEpoch) {
  for (const double rate_hz : {0.25, -0.25, 0.5}) {
    PeakFilter filter({});
    std::vector<double> raw;
    Flight flight;
    flight.rate_radps = rate_hz * 360 * degree;
    fly(filter, flight, 60, 0, &raw);
    // Each satellite gives a peak in every turn after the first one or two. Only the satellite that
    // is nearly ahead gives no peaks.
    EXPECT_GT(raw.size(), 7 * (60 * std::abs(rate_hz) - 3));
    for (const double error : raw) EXPECT_LT(std::abs(error), 1.0) << rate_hz;
  }
}

TEST(PeakFilter, WithoutRotationThereAreNoPeaksAndNoEstimate) {
  PeakFilter filter({});
  Flight flight;
  flight.rate_radps = 0;
  flight.noise = 0.1;
  fly(filter, flight, 30, 0);
  EXPECT_FALSE(filter.running());
}

TEST(PeakFilter, AGyroBiasLagsTheScalarFilterAndIsFoundByTheOtherOne) {
  PeakFilterOptions options;
  PeakFilter scalar(options);
  options.with_bias = true;
  PeakFilter with_bias(options);
  const double bias = 0.5 * degree;
  const double lag = fly(scalar, {}, 120, bias);
  EXPECT_GT(lag, 2);
  EXPECT_LT(std::abs(fly(with_bias, {}, 120, bias)), 0.5);
  EXPECT_NEAR(with_bias.bias() * to_deg, 0.5, 0.1);
}

TEST(PeakFilter, NoiseOfATenthGivesThePapersRawErrorAndAFewDegreesFiltered) {
  PeakFilter filter({});
  Flight flight;
  flight.noise = 0.1;
  std::vector<double> raw;
  const double error = fly(filter, flight, 100, 0, &raw);
  double squares = 0;
  for (const double e : raw) squares += e * e;
  const double rms = std::sqrt(squares / static_cast<double>(raw.size()));
  EXPECT_GT(rms, 4);
  EXPECT_LT(rms, 15);
  EXPECT_LT(std::abs(error), 6);
}

TEST(PeakFilter, ALateEpochCountsForItsOwnTime) {
  PeakFilter in_time({}), late({});
  Flight flight;
  for (int k = 1; k <= 6000; ++k) {
    const double t = k * gyro_dt;
    in_time.predict(flight.rate_radps, gyro_dt);
    late.predict(flight.rate_radps, gyro_dt);
    if (k % 10 == 0) in_time.update({.signals = flight.at(t), .path = flight.path()});
    if (k % 10 == 5 && k > 10)
      late.update({.signals = flight.at(t - 0.05),
                   .path = flight.path(),
                   .age_s = 0.05,
                   .turned_rad = 0.05 * flight.rate_radps});
  }
  EXPECT_NEAR(frame::wrap_pi(late.roll() - in_time.roll()) * to_deg, 0, 0.05);
}

}  // namespace
}  // namespace drydock::roll::peak_filter_test
