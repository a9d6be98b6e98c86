#pragma once

#include <boost/container/static_vector.hpp>
#include <optional>

#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/nmea0183/nmea0183_gnss.hpp"

namespace drydock::device {

struct SatelliteId {
  measurement::Constellation constellation = measurement::Constellation::gps;
  std::uint8_t number = 0;
  friend bool operator==(const SatelliteId&, const SatelliteId&) = default;
};

/// Finds the satellite that an NMEA number means. Talkers GL, GA, GB/BD, GQ and GI, or GSA's system
/// field, name the constellation. Otherwise the number does: 1-32 GPS, 33-64 SBAS (from PRN 120),
/// 65-99 GLONASS, 193-202 QZSS, 301-336 Galileo, 401-463 BeiDou. Empty for an unknown satellite.
std::optional<SatelliteId> identify_satellite(wire::Talker talker, std::optional<int> system,
                                              int number);

/// Collects the GSV and GSA sentences of one epoch. It uses a group of GSV sentences only if the
/// group is complete. Since NMEA 4.10 each signal has a group; a satellite with several signals
/// keeps its strongest C/N0.
class NmeaSatellites {
 public:
  using List = decltype(measurement::GnssSatellites::satellites);

  void add(const wire::Gsv& gsv);
  void add(const wire::Gsa& gsa);
  void clear();

  /// True for the first sentence of a group that has already begun: it belongs to another epoch.
  bool has_again(const wire::Gsv& gsv) const;
  /// True if it uses a satellite that is already used: it belongs to another epoch, unless the GSAs
  /// of this epoch are still coming.
  bool has_again(const wire::Gsa& gsa) const;

  bool complete_group() const { return complete_group_; }
  List list() const;  ///< `used` comes from the GSA sentences

 private:
  /// The sentences of one talker and one signal.
  struct Group {
    wire::Talker talker;
    std::optional<int> signal;
    friend bool operator==(const Group&, const Group&) = default;
  };
  void merge(const measurement::Satellite& satellite);

  boost::container::static_vector<Group, 32> begun_;
  boost::container::static_vector<measurement::Satellite, 64> group_;  ///< of the incomplete group
  int next_sentence_ = 1;
  List satellites_;
  boost::container::static_vector<SatelliteId, 96> used_;
  bool complete_group_ = false;
};

}  // namespace drydock::device
