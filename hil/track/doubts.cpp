#include "hil/track/doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace drydock::track {
namespace {

/// So many fixes, one after the other, are no wild ones.
constexpr std::uint64_t long_run = 10;
/// A scale error of so many sigmas is one; below that size nobody asks for it.
constexpr double surely = 3, least_scale = 0.002;

struct Refused {
  std::uint64_t fixes = 0, refused = 0, run = 0, longest_run = 0;

  void add(bool was_refused) {
    ++fixes;
    refused += was_refused ? 1 : 0;
    run = was_refused ? run + 1 : 0;
    longest_run = std::max(longest_run, run);
  }
};

std::map<std::uint16_t, Refused> refused_fixes(const Gathered& gathered,
                                               const smoothing::Residuals& residuals) {
  std::map<std::uint16_t, Refused> by_device;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const auto& reading = gathered.dive.readings[i];
    if (reading.quantity != smoothing::Quantity::fix) continue;
    by_device[reading.device].add(std::ranges::any_of(
        residuals[i], [](const auto& axis) { return axis.known && !axis.used; }));
  }
  return by_device;
}

std::string wrong_speed_of_sound(const std::string& device,
                                 const measurement::SoundSpeedUsed::Means& means) {
  return fmt::format(
      "{}: used {:.1f} m/s for the speed of sound, its water has {:.1f} ({:.1f} degC, {:.0f} ppt, "
      "{:.0f} m): velocities are {:.2f} % too {}; `sound_speed = {{ source = \"computed\" }}` in "
      "the rig file puts them right",
      device, means.used_mps, means.of_water_mps,
      means.temperature_k - measurement::melting_point_k, means.salinity_ppt, means.depth_m,
      100 * std::abs(means.error()), means.error() > 0 ? "large" : "small");
}

}  // namespace

std::vector<std::string> doubts_of(const Gathered& gathered, const smoothing::Track& track) {
  std::vector<std::string> doubts;
  for (const auto& [device, sum] : refused_fixes(gathered, track.residuals))
    if (sum.longest_run >= long_run)
      doubts.push_back(fmt::format(
          "{}: {} of {} fixes refused, {} one after the other: either they are wrong, or the track "
          "is and errs more than it says; `drydock calibrate` finds wrong sensors",
          gathered.device_name(device), sum.refused, sum.fixes, sum.longest_run));
  for (const auto& [device, water] : gathered.water)
    if (const auto means = water.means(); means && std::abs(means->error()) > least_scale)
      doubts.push_back(wrong_speed_of_sound(gathered.device_name(device), *means));
  if (std::abs(track.bottom_scale) > std::max(least_scale, surely * track.bottom_scale_sigma))
    doubts.push_back(fmt::format(
        "bottom track measures {:.2f} % too {} (1 sigma {:.2f} %), which the track allows for; "
        "`drydock calibrate` writes it into the rig file",
        100 * std::abs(track.bottom_scale), track.bottom_scale > 0 ? "much" : "little",
        100 * track.bottom_scale_sigma));
  return doubts;
}

}  // namespace drydock::track
