#include "drivers/wire/ubx/ubx_satellites.hpp"

#include <array>

#include "drivers/wire/ubx/ubx_payload.hpp"
#include "drivers/wire/ubx/ubx_put.hpp"

namespace drydock::wire {
namespace {

using ubx::bit;

/// The numbers first..last mean the satellites (first - offset)..(last - offset) of a
/// constellation.
struct NumberRange {
  UbxGnss gnss;
  int first, last, offset;
};

// u-blox 8 / M8 Receiver Description, appendix "Satellite Numbering", single svid. 255 is a GLONASS
// satellite whose number is not known yet; it stays 255 as in NAV-SAT.
constexpr std::array<NumberRange, 9> ranges{{
    {UbxGnss::gps, 1, 32, 0},
    {UbxGnss::beidou, 33, 64, 27},
    {UbxGnss::glonass, 65, 96, 64},
    {UbxGnss::sbas, 120, 158, 0},
    {UbxGnss::beidou, 159, 163, 158},
    {UbxGnss::imes, 173, 182, 172},
    {UbxGnss::qzss, 193, 202, 192},
    {UbxGnss::galileo, 211, 246, 210},
    {UbxGnss::glonass, 255, 255, 0},
}};

bool identify(int svid, UbxSatellite& s) {
  for (const NumberRange& range : ranges) {
    if (svid < range.first || svid > range.last) continue;
    s.gnss = range.gnss;
    s.number = static_cast<std::uint8_t>(svid - range.offset);
    return true;
  }
  return false;
}

bool read_channel(Bytes block, UbxSatellite& s) {
  constexpr std::uint8_t ephemeris = 1, almanac = 2, assistance = 3;
  const unsigned flags = block[2];
  if (!identify(block[1], s)) return false;
  s.used = bit(flags, 0);
  s.has_ephemeris = bit(flags, 3);
  s.has_almanac = bit(flags, 5);
  if (bit(flags, 2)) {
    s.orbit_source = s.has_ephemeris ? ephemeris : s.has_almanac ? almanac : assistance;
  }
  if (bit(flags, 4)) s.healthy = false;  // the wire cannot express "known to be healthy"
  s.quality = block[3] & 0xF;
  s.cno_dbhz = ubx::carrier_to_noise(block, 4);
  ubx::read_direction(block, 5, s.elevation_rad, s.azimuth_rad);
  s.residual_m = ubx::value<std::int32_t>(block, 8, 1e2);
  return true;
}

void read_signal(Bytes block, UbxSignal& s) {
  const auto flags = load_le<std::uint16_t>(block, 10);
  s.gnss = static_cast<UbxGnss>(block[0]);
  s.number = block[1];
  s.signal = block[2];
  if (s.gnss == UbxGnss::glonass) s.frequency_number = block[3] - 7;
  s.residual_m = ubx::value<std::int16_t>(block, 4, 10);
  s.cno_dbhz = ubx::carrier_to_noise(block, 6);
  s.quality = block[7];
  s.correction_source = block[8];
  s.ionosphere_model = block[9];
  s.healthy = ubx::health(flags & 3);
  s.pseudorange_used = bit(flags, 3);
  s.carrier_used = bit(flags, 4);
  s.doppler_used = bit(flags, 5);
}

void put_channel(ubx::PayloadOut block, const UbxSatellite& s) {
  constexpr std::uint8_t not_on_a_channel = 255;
  block[0] = s.cno_dbhz ? s.number : not_on_a_channel;
  block[1] = s.number;
  block[2] = static_cast<std::uint8_t>(
      ubx::flag(s.used, 0) | ubx::flag(s.orbit_source != 0, 2) | ubx::flag(s.has_ephemeris, 3) |
      ubx::flag(s.healthy == false, 4) | ubx::flag(s.has_almanac, 5));
  block[3] = s.quality;
  ubx::put<std::uint8_t>(block, 4, s.cno_dbhz, 1);
  ubx::put<std::int8_t>(block, 5, degrees(s.elevation_rad), 1);
  ubx::put<std::int16_t>(block, 6, degrees(s.azimuth_rad), 1);
  ubx::put<std::int32_t>(block, 8, s.residual_m, 0.01);
}

}  // namespace

std::size_t encode(const NavSvinfo& m, std::span<std::uint8_t> out) {
  constexpr std::size_t head = 8, block = 12;
  const ubx::PayloadOut payload = ubx::payload_in(out, head + block * m.satellites.size());
  if (payload.empty()) return 0;
  store_le<std::uint32_t>(payload, 0, static_cast<std::uint32_t>(m.itow.count()));
  payload[4] = static_cast<std::uint8_t>(m.satellites.size());
  payload[5] = NavSvinfo::m8_hardware;
  for (std::size_t i = 0; i < m.satellites.size(); ++i)
    put_channel(payload.subspan(head + block * i, block), m.satellites[i]);
  return ubx::wrap(out, NavSvinfo::class_and_id, payload.size());
}

bool read(Bytes payload, NavSvinfo& m) {
  constexpr std::size_t head = 8, block = 12;
  if (payload.size() < head || payload.size() != head + block * payload[4]) return false;
  m.itow = ubx::itow(payload);
  for (std::size_t at = head; at < payload.size(); at += block) {
    if (!read_channel(payload.subspan(at, block), m.satellites.emplace_back())) {
      m.satellites.pop_back();
    }
  }
  return true;
}

bool read(Bytes payload, NavSig& m) {
  constexpr std::size_t head = 8, block = 16;
  if (payload.size() < head || payload.size() != head + block * payload[5]) return false;
  m.itow = ubx::itow(payload);
  for (std::size_t at = head; at < payload.size(); at += block) {
    read_signal(payload.subspan(at, block), m.signals.emplace_back());
  }
  return true;
}

}  // namespace drydock::wire
