#include "drivers/monitor/values/display_units.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace display_units_test {

using drydock::monitor::clock_text;
using drydock::monitor::device_clock_text;
using drydock::monitor::DisplayUnits;

std::string shown(const std::string& field, double number, const std::string& units = {}) {
  const auto value = DisplayUnits::of(units).shown(field, std::array{number});
  return value.name + ' ' + value.full();
}

TEST(DisplayUnits, APositionHasSevenDecimalsWhichIsOneCentimetre) {
  EXPECT_EQ(shown("latitude_deg", 36.12345678), "latitude 36.1234568 deg");
  EXPECT_EQ(shown("longitude_deg", -139.5), "longitude -139.5000000 deg");
}

TEST(DisplayUnits, WaterFreezesAtZeroDegreesCelsius) {
  EXPECT_EQ(shown("temperature_k", 273.15), "temperature 0.000 °C");
  EXPECT_EQ(shown("temperature_k", 273.15, "K"), "temperature 273.150 K");
}

TEST(DisplayUnits, APropellerOfTwoPiRadiansASecondTurnsSixtyTimesAMinute) {
  EXPECT_EQ(shown("propeller_radps", 2 * M_PI), "propeller 60.00 r/min");
}

TEST(DisplayUnits, AKnotIsANauticalMileAnHourAndABarAHundredKilopascal) {
  EXPECT_EQ(shown("longitudinal_mps", 1852.0 / 3600, "kn,bar"), "longitudinal 1.000 kn");
  EXPECT_EQ(shown("pressure_pa", 101'325, "kn,bar"), "pressure 1.01325 bar");
  EXPECT_EQ(shown("pressure_pa", 101'325), "pressure 101.325 kPa");
}

TEST(DisplayUnits, TheSpeedOfSoundStaysInMetresASecond) {
  EXPECT_EQ(shown("sound_speed_mps", 1490, "kn"), "sound_speed 1490.000 m/s");
}

TEST(DisplayUnits, AnEndingThatEndsWithAnotherIsNotTakenForIt) {
  EXPECT_EQ(shown("specific_force_mps2", 9.80665), "specific_force 9.80665 m/s2");
  EXPECT_EQ(shown("angular_rate_degps", 0.0041781), "angular_rate 0.0042 deg/s");
}

TEST(DisplayUnits, ABeamWithoutABottomIsADash) {
  const auto value = DisplayUnits().shown("range_m", std::array{59.65, std::nan(""), 60.0, 61.25});
  EXPECT_EQ(value.full(), "59.650 - 60.000 61.250 m");
}

TEST(DisplayUnits, ACountIsAWholeNumberWithoutUnit) {
  EXPECT_EQ(shown("satellites_used", 9), "satellites_used 9");
}

TEST(DisplayUnits, AnUnknownUnitIsRefusedWithTheAllowedOnes) {
  try {
    DisplayUnits::of("kn,furlong");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("\"furlong\" is no unit; allowed: m/s2"),
              std::string::npos)
        << error.what();
  }
}

TEST(DisplayUnits, TheBillionthUnixSecondWasAtOneFortySixForty) {
  EXPECT_EQ(clock_text(1'000'000'000, 0), "01:46:40");
  EXPECT_EQ(clock_text(1'000'000'000.25), "01:46:40.250");
}

TEST(DisplayUnits, AClockThatCountsFrom1970ShowsTheTimeOfDayAndAnotherItsSeconds) {
  EXPECT_EQ(device_clock_text(1'000'000'000.25), "01:46:40.250");
  EXPECT_EQ(device_clock_text(547'218.5), "547218.500 s");  // of the GPS week
}

TEST(DisplayUnits, ATimeThatRoundsUpToADayIsMidnight) {
  EXPECT_EQ(clock_text(86'399.9999, 3), "00:00:00.000");
}

TEST(DisplayUnits, TheTimeOfAFixIsAClock) {
  EXPECT_EQ(shown("utc_s", 1'000'000'000.2), "utc 01:46:40.20 UTC");
}

}  // namespace display_units_test
