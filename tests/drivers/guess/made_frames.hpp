#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>

#include "drivers/wire/described/checksums.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

/// Frames of values like a sensor's, laid out as a maker's document says.
namespace drydock::described::test {

/// `size`: of the integer's bytes the lowest so many.
template <class T>
void put(wire::testing::Buffer& frame, T value, bool big = false, std::size_t size = sizeof(T)) {
  std::array<std::uint8_t, sizeof(T)> raw{};
  std::memcpy(raw.data(), &value, sizeof(T));
  std::reverse(raw.begin(), raw.begin() + (big ? std::ptrdiff_t(size) : 0));
  frame.insert(frame.end(), raw.begin(), raw.begin() + std::ptrdiff_t(size));
}

inline void put_checksum(wire::testing::Buffer& frame, std::string_view name, std::size_t from,
                         bool big) {
  wire::described::Checksum checksum;
  ASSERT_TRUE(wire::described::Checksum::find(name, checksum));
  put(frame, checksum.of(wire::Bytes(frame).subspan(from)), big, checksum.size());
}

/// A value that wanders about 0 with this standard deviation.
class Wander {
 public:
  explicit Wander(double sigma, std::uint32_t seed) : sigma_(sigma), random_(seed) {}
  double next() { return value_ += normal_(random_) * sigma_ * 0.14 - 0.01 * value_; }
  std::int32_t integer() { return static_cast<std::int32_t>(std::lround(next())); }

 private:
  double sigma_, value_ = 0;
  std::mt19937 random_;
  std::normal_distribution<> normal_;
};

}  // namespace drydock::described::test
