#include "hil/characterize/samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "hil/characterize/device_figures.hpp"

namespace drydock::characterize {
namespace {

using std::numbers::pi;

constexpr double degree_rad = pi / 180, earth_m = 6'371'009;

Subject subject(rig_config::DeviceKind kind) {
  Subject subject;
  subject.kind = kind;
  return subject;
}

/// Readings at 10 Hz of a compass that lies still, within 0 to 2 pi.
Samples still_compass(double heading_deg, double sigma_deg) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(heading_deg, sigma_deg);
  Samples samples(subject(rig_config::DeviceKind::attitude));
  for (int i = 0; i < 3000; ++i) {
    measurement::AttitudeSample sample;
    sample.origin.valid_at = sample.origin.received_at =
        measurement::Stamp{std::chrono::milliseconds{100 * i}};
    sample.heading_rad = std::fmod(noise(random) + 360, 360) * degree_rad;
    samples.add(sample);
  }
  return samples;
}

double heading_noise_deg(double heading_deg, double sigma_deg) {
  const auto figures = figures_of(still_compass(heading_deg, sigma_deg)).value();
  const auto& heading = figures.quantities.at(0).axes.at(2).value();
  EXPECT_TRUE(heading.steadiness.steady) << heading_deg;
  return heading.noise->density->value * std::sqrt(10) / degree_rad;
}

TEST(Samples, ACompassNearNorthIsAsQuietAsAnyOther) {
  EXPECT_NEAR(heading_noise_deg(180, 0.3), 0.3, 0.02);
  EXPECT_NEAR(heading_noise_deg(359.5, 0.3), 0.3, 0.02);
  EXPECT_NEAR(heading_noise_deg(0.1, 0.5), 0.5, 0.03);
}

TEST(Samples, AReceiverNearTheDateLineIsAsQuietAsAnyOther) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> noise;
  Samples samples(subject(rig_config::DeviceKind::gnss));
  for (int i = 0; i < 1000; ++i) {
    measurement::GnssFix fix;
    fix.position = {0, std::remainder(pi + noise(random) / earth_m, 2 * pi)};
    samples.add(fix);
  }
  double squares = 0;
  for (const auto& position : samples.quantities[0]) {
    const double from_first = position.y() - samples.quantities[0][1].y();
    squares += from_first * from_first;
  }
  EXPECT_LT(std::sqrt(squares / 1000), 4);  // 1 m of noise, from a place within three sigmas
}

/// GPS counts from 1980 and its week from Sunday, so times of week less UTC are none.
TEST(Samples, OnlyTheHostsClockTellsAReceiversLatency) {
  using enum Subject::Times;
  for (const auto times : {of_arrival, of_device, none}) {
    Subject of = subject(rig_config::DeviceKind::gnss);
    of.times = times;
    Samples samples(of);
    measurement::GnssFix fix;
    fix.origin.received_at = measurement::Stamp{std::chrono::seconds{547218}};
    fix.utc = measurement::Stamp{std::chrono::seconds{1'795'248'000}};
    samples.add(fix);
    EXPECT_EQ(samples.utc_latency_s.size(), times == of_arrival ? 1u : 0u);
  }
}

}  // namespace
}  // namespace drydock::characterize
