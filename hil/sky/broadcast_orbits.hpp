#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hil/sky/ephemeris.hpp"

namespace drydock::sky {

/// A broadcast record is valid up to this time before and after toe.
inline constexpr std::chrono::hours record_holds{2};

/// The records of one or more files; one is chosen per satellite and time. Two kinds of records are
/// refused whatever their health bits say: records with an absurd orbit, and records that disagree
/// with most records of the same satellite near that time, for example under a wrong satellite
/// number.
class BroadcastOrbits {
 public:
  explicit BroadcastOrbits(const std::vector<Ephemeris>& records);

  struct Refused {
    Ephemeris record;
    std::string why;
  };
  std::span<const Refused> refused() const { return refused_; }  ///< never chosen

  enum class Health { healthy, any };

  /// The record of a satellite with the nearest toe, within 2 h before or after; of two equally
  /// near, the earlier. By default unhealthy records are ignored. Null if there is none.
  const Ephemeris* nearest(int prn, GpsTime time, Health health = Health::healthy) const;

  /// Number of satellites with a healthy record at that time.
  int usable(GpsTime time) const;

  /// First and last toe of the sound records. Equal and zero if there are none.
  std::pair<GpsTime, GpsTime> span() const;

 private:
  void refuse_strangers();

  std::vector<Ephemeris> records_;  ///< sound ones, ordered by satellite and toe
  std::vector<Refused> refused_;
};

}  // namespace drydock::sky
