#include "drivers/wire/decimal_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace drydock::wire {
namespace {

std::string of_library(double value, std::chars_format format, int precision) {
  std::array<char, 1024> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, format, precision).ptr;
  return {text.data(), end};
}

std::string general(double value) {
  std::array<char, decimal_text_size> text;
  return {text.data(), general_text(value, text.data())};
}

std::string fixed(double value, int decimals) {
  std::array<char, decimal_text_size> text;
  const char* const end = fixed_text(value, decimals, text.data());
  return end == nullptr ? "no room"
                        : std::string(text.data(), static_cast<std::size_t>(end - text.data()));
}

/// Measured values, values half-way between two texts, powers of ten and their neighbours, and
/// doubles of any size.
std::vector<double> values() {
  std::vector<double> all{0.0,         5e-324,         1e22,        123456789.5,
                          99999999.95, 0.999999999999, 9.9999999949};
  for (int exponent = -12; exponent < 16; ++exponent) {
    const double power = std::pow(10, exponent);
    for (const double one : {power, std::nextafter(power, 0), std::nextafter(power, 1e300)})
      all.push_back(one);
  }
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> measured(0, 2000);
  for (int i = 0; i < 100'000; ++i) {
    all.push_back(measured(random));
    all.push_back(measured(random) * 1e-6);
    all.push_back(static_cast<double>(random() % 1'000'000) / 1024);  // an exact half now and then
    const auto any = std::bit_cast<double>(random() >> 1);
    if (std::isfinite(any)) all.push_back(any);
  }
  const std::size_t count = all.size();
  for (std::size_t i = 0; i < count; ++i) all.push_back(-all[i]);
  return all;
}

TEST(DecimalText, HasTheCharactersOfTheLibraryWithNineSignificantDigits) {
  for (const double value : values())
    ASSERT_EQ(general(value), of_library(value, std::chars_format::general, 9));
}

TEST(DecimalText, HasTheCharactersOfTheLibraryWithFixedDecimals) {
  for (const double value : values()) {
    if (std::abs(value) > 1e30) continue;  // more digits than there is room for
    for (const int decimals : {0, 1, 2, 3, 9, 15, 17})
      ASSERT_EQ(fixed(value, decimals), of_library(value, std::chars_format::fixed, decimals));
  }
}

TEST(DecimalText, SaysThatThereIsNoRoom) {
  EXPECT_EQ(fixed(1e300, 0), "no room");
  EXPECT_EQ(fixed(1, 70), "no room");
}

}  // namespace
}  // namespace drydock::wire
