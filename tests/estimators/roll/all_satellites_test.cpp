#include "estimators/roll/all_satellites.hpp"

#include <gtest/gtest.h>

#include "tests/estimators/roll/flight.hpp"

namespace drydock::roll::all_satellites_test {
namespace {

using test::degree;
using test::Flight;

constexpr double gyro_dt = 0.01, to_deg = 1 / degree;

double error_deg(const AllSatellites& filter, const Flight& flight, double t) {
  return frame::wrap_pi(filter.roll() - flight.roll(t)) * to_deg;
}

/// Feeds epochs at 10 Hz. `change` may alter the signals of an epoch.
template <class Change>
void fly(AllSatellites& filter, Flight& flight, double seconds, double bias_radps,
         Change&& change) {
  const int samples = static_cast<int>(seconds / gyro_dt);
  for (int k = 1; k <= samples; ++k) {
    filter.predict(flight.rate_radps + bias_radps, gyro_dt);
    if (k % 10 != 0) continue;
    flight.at(k * gyro_dt);
    change(flight.signals);
    filter.update({.signals = flight.signals, .path = flight.path()});
  }
}

void as_received(const std::array<Signal, 8>&) {}

TEST(AllSatellites, FindsAnyFirstRollWithinASecondOrTwo) {
  for (double first = -170; first < 190; first += 20) {
    AllSatellites filter({});
    Flight flight;
    flight.first_roll = first * degree;
    flight.noise = 0.1;
    fly(filter, flight, 3, 0, as_received);
    EXPECT_LT(std::abs(error_deg(filter, flight, 3)), 6) << first;
    EXPECT_LT(filter.hypotheses(), 4u) << first;
  }
}

TEST(AllSatellites, LearnsBiasAndCommonGain) {
  AllSatellites filter({});
  Flight flight;
  flight.gain = 0.8;
  flight.noise = 0.1;
  fly(filter, flight, 100, 0.5 * degree, as_received);
  EXPECT_NEAR(filter.bias() * to_deg, 0.5, 0.1);
  EXPECT_NEAR(filter.common_gain(), 0.8, 0.1);
  EXPECT_LT(std::abs(error_deg(filter, flight, 100)), 2);
}

TEST(AllSatellites, SaysItsErrorWhileSeveralStartsAreStillPossible) {
  AllSatellites filter({});
  Flight flight;
  flight.noise = 0.1;
  filter.update({.signals = std::span(flight.at(0)).first(1), .path = flight.path()});
  EXPECT_GT(filter.hypotheses(), 4u);
  EXPECT_GT(std::sqrt(filter.roll_variance()) * to_deg, 20);
}

TEST(AllSatellites, ASatelliteThatIsLostSaysThatItIsWeak) {
  AllSatellitesOptions options;
  options.antenna.tracking_limit = 0.05;
  AllSatellites told(options);
  options.antenna.tracking_limit.reset();
  AllSatellites untold(options);
  for (AllSatellites* filter : {&told, &untold}) {
    Flight flight;
    flight.noise = 0.1;
    fly(*filter, flight, 60, 0.1 * degree, [](auto& signals) {
      for (auto& signal : signals)
        if (*signal.power < 0.05) signal.power.reset();
    });
    EXPECT_LT(std::abs(error_deg(*filter, flight, 60)), 3);
  }
  EXPECT_LT(told.roll_variance(), untold.roll_variance());
}

TEST(AllSatellites, RoundedPowersAreTakenForWhatTheyAre) {
  AllSatellitesOptions options;
  options.antenna.resolution_db = 3;
  AllSatellites filter(options);
  Flight flight;
  flight.noise = 0.1;
  fly(filter, flight, 60, 0, [](auto& signals) {
    for (auto& signal : signals) {
      const double power = std::max(*signal.power, 1e-3);
      signal.power = std::pow(10, 0.3 * std::round(10 * std::log10(power) / 3));
    }
  });
  EXPECT_LT(std::abs(error_deg(filter, flight, 60)),
            3 * std::sqrt(filter.roll_variance()) * to_deg);
}

TEST(AllSatellites, AnAbsurdPowerIsOutsideTheGateAndCounted) {
  AllSatellites filter({});
  Flight flight;
  flight.noise = 0.1;
  fly(filter, flight, 30, 0, as_received);
  const double before = filter.roll();
  const auto rejected = filter.rejected();
  flight.at(30);
  flight.signals[0].power = 5;
  filter.update({.signals = std::span(flight.signals).first(1), .path = flight.path()});
  EXPECT_EQ(filter.rejected(), rejected + 1);
  EXPECT_EQ(filter.roll(), before);
}

TEST(AllSatellites, ALateEpochIsTakenForItsOwnTime) {
  AllSatellites filter({});
  Flight flight;
  flight.noise = 0.1;
  const double late = 0.08;
  for (int k = 9; k <= 6000; ++k) {
    filter.predict(flight.rate_radps + 0.5 * degree, gyro_dt);
    if (k % 10 == 8)
      filter.update({.signals = flight.at(k * gyro_dt - late),
                     .path = flight.path(),
                     .age_s = late,
                     .turned_rad = (flight.rate_radps + 0.5 * degree) * late});
  }
  EXPECT_LT(std::abs(error_deg(filter, flight, 60)), 2.5);
}

TEST(AllSatellites, MoreSatellitesThanPlacesArePassedOver) {
  AllSatellites filter({});
  std::array<Signal, 40> many;
  for (std::size_t i = 0; i < many.size(); ++i)
    many[i] = {static_cast<std::uint16_t>(i), toward_ned(0.5, static_cast<double>(i)), 0.5};
  filter.update({.signals = many, .path = {0, 0.3}});
  EXPECT_TRUE(std::isfinite(filter.roll()));
}

}  // namespace
}  // namespace drydock::roll::all_satellites_test
