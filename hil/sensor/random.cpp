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

Eigen::Vector3d RandomStream::normal3() {
  const double x = normal();
  const double y = normal();
  return {x, y, normal()};
}

}  // namespace drydock::sensor
