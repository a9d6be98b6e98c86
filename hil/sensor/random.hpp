#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string_view>

/// Random numbers that depend on (seed, device, stream) and nothing else.
namespace drydock::sensor {

/// SplitMix64 (Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators, OOPSLA 2014).
constexpr std::uint64_t splitmix64(std::uint64_t& state) {
  std::uint64_t z = state += 0x9E3779B97F4A7C15;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return z ^ (z >> 31);
}

class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view device, std::string_view stream);

  std::uint64_t next() { return splitmix64(state_); }
  double uniform();  ///< [0, 1), 53 bits
  double normal();   ///< N(0, 1), Box-Muller
  /// sigma * normal(), to the last bit. Where sigma is 0 it only draws, and finds the sign of 0.
  double normal(double sigma);
  Eigen::Vector3d normal3();

 private:
  std::uint64_t state_;
};

}  // namespace drydock::sensor
