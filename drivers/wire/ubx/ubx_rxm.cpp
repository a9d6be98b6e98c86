#include "drivers/wire/ubx/ubx_rxm.hpp"

#include <cmath>

#include "drivers/wire/ubx/ubx_payload.hpp"

namespace drydock::wire {
namespace {

using ubx::bit;

template <class T>
std::optional<double> finite(Bytes block, std::size_t offset) {
  const double number = load_le<T>(block, offset);
  return std::isfinite(number) ? std::optional{number} : std::nullopt;
}

std::optional<int> frequency_number(UbxGnss gnss, std::uint8_t sent) {
  return gnss == UbxGnss::glonass ? std::optional{sent - 7} : std::nullopt;
}

void read_measurement(Bytes block, RawMeasurement& m) {
  const unsigned tracking = block[30];
  constexpr unsigned unknown = 0xF;
  const unsigned range = block[27] & 0xFu, carrier = block[28] & 0xFu, doppler = block[29] & 0xFu;
  m.gnss = static_cast<UbxGnss>(block[20]);
  m.number = block[21];
  m.signal = block[22];
  m.frequency_number = frequency_number(m.gnss, block[23]);
  m.lock_time = std::chrono::milliseconds{load_le<std::uint16_t>(block, 24)};
  m.cno_dbhz = ubx::carrier_to_noise(block, 26);
  if (bit(tracking, 0)) {
    m.pseudorange_m = finite<double>(block, 0);
    m.pseudorange_sigma_m = std::ldexp(0.01, static_cast<int>(range));
  }
  if (bit(tracking, 1)) {
    m.carrier_phase_cycles = finite<double>(block, 8);
    if (carrier != unknown) m.carrier_sigma_cycles = 0.004 * carrier;
  }
  m.doppler_hz = finite<float>(block, 16);
  m.doppler_sigma_hz = std::ldexp(0.002, static_cast<int>(doppler));
  m.half_cycle_resolved = bit(tracking, 2);
}

}  // namespace

bool read(Bytes payload, RxmRawx& m) {
  constexpr std::size_t head = 16, block = 32;
  if (payload.size() < head || payload.size() != head + block * payload[11]) return false;
  const auto time = finite<double>(payload, 0);
  if (!time) return false;
  m.receiver_time_s = *time;
  m.gps_week = load_le<std::uint16_t>(payload, 8);
  if (bit(payload[12], 0)) m.leap_seconds = load_le<std::int8_t>(payload, 10);
  m.clock_reset = bit(payload[12], 1);
  for (std::size_t at = head; at < payload.size(); at += block) {
    read_measurement(payload.subspan(at, block), m.measurements.emplace_back());
  }
  return true;
}

bool read(Bytes payload, RxmSfrbx& m) {
  constexpr std::size_t head = 8, word = 4;
  if (payload.size() < head || payload.size() != head + word * payload[4]) return false;
  m.gnss = static_cast<UbxGnss>(payload[0]);
  m.number = payload[1];
  m.signal = payload[2];
  m.frequency_number = frequency_number(m.gnss, payload[3]);
  m.channel = payload[5];
  for (std::size_t at = head; at < payload.size(); at += word) {
    m.words.push_back(load_le<std::uint32_t>(payload, at));
  }
  return true;
}

}  // namespace drydock::wire
