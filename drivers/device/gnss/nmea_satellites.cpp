#include "drivers/device/gnss/nmea_satellites.hpp"

#include <algorithm>
#include <array>

namespace drydock::device {

namespace {

using measurement::Constellation;
using measurement::Satellite;

/// The NMEA numbers first..last mean the satellites (first - offset)..(last - offset) of a
/// constellation.
struct NumberRange {
  Constellation constellation;
  int first, last, offset;
};

// NMEA 0183 4.10 and the extended numbering of u-blox. If the constellation is named, its own rows
// are searched first, so that 201 from a BeiDou talker is not QZSS.
constexpr std::array<NumberRange, 14> ranges{{
    {Constellation::gps, 1, 32, 0},
    {Constellation::sbas, 33, 64, -87},
    {Constellation::glonass, 65, 99, 64},
    {Constellation::sbas, 120, 158, 0},
    {Constellation::qzss, 193, 202, 192},
    {Constellation::galileo, 301, 336, 300},
    {Constellation::beidou, 401, 463, 400},
    // These apply only if talker or system names the constellation:
    {Constellation::glonass, 1, 32, 0},
    {Constellation::galileo, 1, 36, 0},
    {Constellation::beidou, 1, 63, 0},
    {Constellation::beidou, 201, 263, 200},
    {Constellation::qzss, 1, 10, 0},
    {Constellation::navic, 1, 14, 0},
    {Constellation::beidou, 141, 177, 140},
}};
constexpr std::size_t ranges_of_any_talker = 7;

std::optional<Constellation> named_constellation(wire::Talker talker, std::optional<int> system) {
  if (system) {
    constexpr std::array by_system{Constellation::gps,     Constellation::glonass,
                                   Constellation::galileo, Constellation::beidou,
                                   Constellation::qzss,    Constellation::navic};
    if (*system >= 1 && *system <= static_cast<int>(by_system.size())) {
      return by_system[static_cast<std::size_t>(*system - 1)];
    }
  }
  const std::string_view name = talker.text();
  if (name == "GL") return Constellation::glonass;
  if (name == "GA") return Constellation::galileo;
  if (name == "GB" || name == "BD") return Constellation::beidou;
  if (name == "GQ" || name == "QZ") return Constellation::qzss;
  if (name == "GI") return Constellation::navic;
  return {};
}

SatelliteId id_in(const NumberRange& range, int number) {
  return {range.constellation, static_cast<std::uint8_t>(number - range.offset)};
}

}  // namespace

std::optional<SatelliteId> identify_satellite(wire::Talker talker, std::optional<int> system,
                                              int number) {
  const auto holds = [number](const NumberRange& r) {
    return number >= r.first && number <= r.last;
  };
  const auto named = named_constellation(talker, system);
  if (named && *named != Constellation::gps) {
    for (const NumberRange& range : ranges) {
      if (range.constellation == *named && holds(range)) return id_in(range, number);
    }
  }
  for (std::size_t i = 0; i < ranges_of_any_talker; ++i) {
    if (holds(ranges[i])) return id_in(ranges[i], number);
  }
  return {};
}

void NmeaSatellites::add(const wire::Gsv& gsv) {
  const int number = gsv.sentence_number.value_or(0);
  if (number == 1) {
    group_.clear();
    next_sentence_ = 1;
    if (begun_.size() < begun_.capacity()) begun_.push_back({gsv.talker, gsv.signal});
  }
  if (number != next_sentence_) {  // a sentence was lost: the group is not complete
    next_sentence_ = 0;
    return;
  }
  ++next_sentence_;
  for (const wire::GsvSatellite& seen : gsv.satellites) {
    const auto id = identify_satellite(gsv.talker, {}, seen.number);
    if (!id || group_.size() == group_.capacity()) continue;
    group_.push_back({id->constellation, id->number, seen.cno_dbhz, seen.elevation_rad,
                      seen.azimuth_rad, false});
  }
  if (number != gsv.sentences) return;
  for (const Satellite& satellite : group_) merge(satellite);
  group_.clear();
  next_sentence_ = 0;
  complete_group_ = true;
}

void NmeaSatellites::merge(const Satellite& satellite) {
  const auto same = std::ranges::find_if(satellites_, [&](const Satellite& s) {
    return s.constellation == satellite.constellation && s.number == satellite.number;
  });
  if (same != satellites_.end()) {
    same->cno_dbhz = std::max(same->cno_dbhz, satellite.cno_dbhz);  // empty is the least value
    if (!same->elevation_rad) same->elevation_rad = satellite.elevation_rad;
    if (!same->azimuth_rad) same->azimuth_rad = satellite.azimuth_rad;
  } else if (satellites_.size() < satellites_.capacity()) {
    satellites_.push_back(satellite);
  }
}

void NmeaSatellites::add(const wire::Gsa& gsa) {
  for (const int number : gsa.satellites_used) {
    const auto id = identify_satellite(gsa.talker, gsa.system, number);
    if (id && used_.size() < used_.capacity()) used_.push_back(*id);
  }
}

bool NmeaSatellites::has_again(const wire::Gsv& gsv) const {
  return gsv.sentence_number == 1 &&
         std::ranges::find(begun_, Group{gsv.talker, gsv.signal}) != begun_.end();
}

bool NmeaSatellites::has_again(const wire::Gsa& gsa) const {
  return std::ranges::any_of(gsa.satellites_used, [&](int number) {
    const auto id = identify_satellite(gsa.talker, gsa.system, number);
    return id && std::ranges::find(used_, *id) != used_.end();
  });
}

void NmeaSatellites::clear() {
  begun_.clear();
  group_.clear();
  next_sentence_ = 0;
  satellites_.clear();
  used_.clear();
  complete_group_ = false;
}

NmeaSatellites::List NmeaSatellites::list() const {
  List list = satellites_;
  for (Satellite& satellite : list) {
    satellite.used = std::ranges::find(used_, SatelliteId{satellite.constellation,
                                                          satellite.number}) != used_.end();
  }
  return list;
}

}  // namespace drydock::device
