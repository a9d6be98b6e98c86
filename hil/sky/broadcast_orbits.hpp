#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hil/sky/ephemeris.hpp"

namespace drydock::sky {

/// The broadcast does not fit further from its time than this.
inline constexpr std::chrono::hours record_holds{2};

/// The records of one or more files, from which one is chosen per satellite and instant. Refused
/// whatever their health bits say: records with an absurd orbit, and those that put the satellite
/// elsewhere than most of its records of the time do, as when another's stand under its number.
class BroadcastOrbits {
 public:
  explicit BroadcastOrbits(const std::vector<Ephemeris>& records);

  struct Refused {
    Ephemeris record;
    std::string why;
  };
  std::span<const Refused> refused() const { return refused_; }  ///< never chosen

  enum class Health { healthy, any };

  /// The record of a satellite whose toe is nearest, within 2 h before or after; of two equally
  /// near the earlier. By default an unhealthy one is as if it were not there. nullptr if none.
  const Ephemeris* nearest(int prn, GpsTime time, Health health = Health::healthy) const;

  /// Satellites with a healthy record at that time.
  int usable(GpsTime time) const;

  /// First and last toe of the sound records; equal and zero when there are none.
  std::pair<GpsTime, GpsTime> span() const;

 private:
  void refuse_strangers();

  std::vector<Ephemeris> records_;  ///< sound ones, by satellite and toe
  std::vector<Refused> refused_;
};

}  // namespace drydock::sky
