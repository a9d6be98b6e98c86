#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "hil/score/pairs.hpp"

namespace drydock::score {

/// Root mean square, mean and largest length of errors.
struct Lengths {
  double rms = 0, mean = 0, max = 0;
};

/// Squared errors over their covariance, per axis; 1 is consistent.
struct Nees {
  std::uint64_t covariances = 0;  ///< pairs with one of what is compared
  std::uint64_t pairs = 0;        ///< those whose covariance can be inverted
  std::optional<double> mean;
};

/// The numbers of a state that can be compared.
inline constexpr std::array part_names{"north",          "east",          "down",
                                       "roll",           "pitch",         "heading",
                                       "velocity_north", "velocity_east", "velocity_down"};
inline constexpr std::array body_velocity_names{"velocity_forward", "velocity_right",
                                                "velocity_down"};

/// What a track of estimates is worth. Empty: the estimates do not give it.
struct Errors {
  std::uint64_t pairs = 0;
  std::array<std::uint64_t, part_names.size()> told{};  ///< pairs that compare it
  bool velocity_in_body = false;
  std::optional<Lengths> ate_m;  ///< absolute trajectory error: length of the position's error, of
                                 ///< the axes that are told
  std::optional<double> horizontal_rms_m, vertical_rms_m, end_m;
  std::optional<Lengths> attitude_deg;  ///< angle of the turn between both attitudes
  std::optional<Lengths> roll_deg, pitch_deg, heading_deg;
  std::optional<Lengths> velocity_mps;  ///< length of its error, of the axes that are told
  Nees position_nees, attitude_nees, velocity_nees;
  std::uint64_t rpe_pairs = 0;
  std::optional<Lengths> rpe_m;  ///< relative pose error: of the way made good in the interval
  std::optional<Lengths> rpe_deg;
};

/// Two states whose distance in time is off by more than this share of the interval are no pair of
/// a relative error: an error over 10 s says nothing about 1 s. evo has the same share.
inline constexpr double rpe_tolerance = 0.1;

/// `interval`: of the relative pose error. With attitudes the way is in the axes of its beginning.
Errors errors_of(const std::vector<Pair>& pairs, std::chrono::nanoseconds interval);

/// Of a number in `told`.
inline const char* part_name(const Errors& errors, std::size_t part) {
  constexpr std::size_t velocity = part_names.size() - body_velocity_names.size();
  return errors.velocity_in_body && part >= velocity ? body_velocity_names.at(part - velocity)
                                                     : part_names.at(part);
}

}  // namespace drydock::score
