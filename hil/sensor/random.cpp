#include "hil/sensor/random.hpp"

#include <cmath>
#include <numbers>

namespace drydock::sensor {
namespace {

// FNV-1a, 64 bits (Fowler, Noll, Vo).
std::uint64_t hash(std::string_view text) {
  std::uint64_t h = 0xCBF29CE484222325;
  for (const char c : text) h = (h ^ static_cast<std::uint8_t>(c)) * 0x100000001B3;
  return h;
}

}  // namespace

RandomStream::RandomStream(std::uint64_t seed, std::string_view device, std::string_view stream) {
  std::uint64_t of_device = splitmix64(seed) ^ hash(device);
  std::uint64_t of_stream = splitmix64(of_device) ^ hash(stream);
  state_ = splitmix64(of_stream);
}

double RandomStream::uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

double RandomStream::normal() {
  const double radius = std::sqrt(-2 * std::log(1 - uniform()));
  return radius * std::cos(2 * std::numbers::pi * uniform());
}

double RandomStream::normal(double sigma) {
  if (sigma != 0) return sigma * normal();
  const bool on_origin = uniform() == 0;  // there the radius is -0
  const double turn = uniform(), from_half = std::abs(turn - 0.5);
  // The cosine of a turn is negative within a quarter around the half; rounding decides at its
  // ends.
  constexpr double quarter = 0.25, rounding = 1e-9;
  const bool left = std::abs(from_half - quarter) < rounding
                        ? std::cos(2 * std::numbers::pi * turn) < 0
                        : from_half < quarter;
  return left != on_origin ? -sigma : sigma;
}

Eigen::Vector3d RandomStream::normal3() {
  const double x = normal();
  const double y = normal();
  return {x, y, normal()};
}

}  // namespace drydock::sensor
