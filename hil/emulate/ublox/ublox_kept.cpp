#include "hil/emulate/ublox/ublox_kept.hpp"

#include <algorithm>

namespace drydock::emulate::ublox {
namespace {

constexpr std::uint16_t cfg_inf = 0x0602, cfg_ant = 0x0613, cfg_nmea = 0x0617, cfg_odo = 0x061E,
                        cfg_navx5 = 0x0623, cfg_tp5 = 0x0631, cfg_itfm = 0x0639;

constexpr auto delivered = std::to_array<KeptMessage>({
    {cfg_inf, 10, true, {0}},
    {cfg_inf, 10, true, {1, 0, 0, 0, 7, 7, 7, 7, 7, 7}},  // NMEA: errors, warnings, notices
    {cfg_ant, 4, false, {0x1B, 0, 0xF0, 0xB9}},
    {cfg_nmea, 20, false, {0, 0x40, 0, 2, 0, 0, 0, 0, 0, 0, 0, 1}},  // NMEA 4.0, version 1
    {cfg_odo, 20, false, {0, 0, 0, 0, 0, 0, 0, 0, 25, 70, 25, 102, 10, 50, 0, 0, 153, 76}},
    // 3 to 32 satellites of at least 6 dBHz, weeks from 1867, orbits within 100 m
    {cfg_navx5, 40, false, {2, 0, 0xFF, 0xFF, 0, 0, 0, 0, 0, 0, 3, 32, 6, 0, 0,  0,
                            0, 0, 0x4B, 7,    0, 0, 0, 0, 0, 0, 0, 0,  0, 0, 100}},
    // 50 ns of cable, a pulse of 100 ms each second once there is a fix
    {cfg_tp5, 32, true, {0, 1, 0, 0, 50,   0,    0, 0, 0x40, 0x42, 0x0F, 0, 0x40, 0x42, 0x0F, 0,
                         0, 0, 0, 0, 0xA0, 0x86, 1, 0, 0,    0,    0,    0, 0xF7, 0,    0,    0}},
    {cfg_tp5, 32, true, {1,    1,    0, 0, 50,   0,    0, 0, 4, 0, 0, 0, 1,    0, 0, 0,
                         0x48, 0xE8, 1, 0, 0xA0, 0x86, 1, 0, 0, 0, 0, 0, 0xFE, 0, 0, 0}},
    {cfg_itfm, 8, false, {0xF3, 0xAC, 0x62, 0x2D, 0x1E, 3}},
});

/// Whether the message is the one that a payload of this id speaks of.
bool is_meant(const KeptMessage& message, std::uint16_t id, wire::Bytes payload) {
  if (message.id != id) return false;
  return !message.selects || payload.empty() || message.payload[0] == payload[0];
}

}  // namespace

void KeptMessages::restart() { messages_.assign(delivered.begin(), delivered.end()); }

bool KeptMessages::has(std::uint16_t id) const {
  return std::ranges::find(messages_, id, &KeptMessage::id) != messages_.end();
}

wire::Bytes KeptMessages::polled(std::uint16_t id, wire::Bytes payload) const {
  const auto found = std::ranges::find_if(
      messages_, [&](const auto& message) { return is_meant(message, id, payload); });
  if (found == messages_.end() || payload.size() > (found->selects ? 1u : 0u)) return {};
  return wire::Bytes{found->payload}.first(found->size);
}

bool KeptMessages::take(std::uint16_t id, wire::Bytes payload) {
  const auto found = std::ranges::find_if(
      messages_, [&](const auto& message) { return is_meant(message, id, payload); });
  if (found == messages_.end() || payload.size() != found->size) return false;
  std::ranges::copy(payload, found->payload.begin());
  return true;
}

}  // namespace drydock::emulate::ublox
