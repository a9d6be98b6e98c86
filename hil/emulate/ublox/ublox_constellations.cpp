#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "drivers/wire/bytes.hpp"
#include "hil/emulate/ublox/ublox_dialogue.hpp"

/// CFG-GNSS: the constellations of a receiver, their channels and signals.
namespace drydock::emulate::ublox {

namespace ubx = wire::ubx;
using wire::load_le;
using wire::store_le;

namespace {

/// A signal of a constellation: its item, and its bit in the mask of CFG-GNSS.
struct GnssSignal {
  std::size_t item;
  std::uint8_t bit;
};

/// A constellation as CFG-GNSS has it: its number, the channels that an M8 and an F9 keep for it at
/// least and at most, and its two signals on an F9 (twice the same: it has one).
struct GnssBlock {
  std::size_t item;
  std::uint8_t gnss;
  std::array<std::uint8_t, 2> m8_channels, f9_channels;
  std::array<GnssSignal, 2> signals;
};
constexpr auto gnss_blocks = std::to_array<GnssBlock>({
    {gps, 0, {8, 16}, {8, 16}, {{{gps_l1, 0}, {gps_l2, 4}}}},
    {sbas, 1, {1, 3}, {1, 3}, {{{sbas_l1, 0}, {sbas_l1, 0}}}},
    {galileo, 2, {4, 8}, {10, 18}, {{{galileo_e1, 0}, {galileo_e5b, 5}}}},
    {beidou, 3, {8, 16}, {2, 5}, {{{beidou_b1, 0}, {beidou_b2, 4}}}},
    {qzss, 5, {0, 3}, {3, 4}, {{{qzss_l1, 0}, {qzss_l2, 4}}}},
    {glonass, 6, {8, 14}, {8, 12}, {{{glonass_l1, 0}, {glonass_l2, 4}}}},
});
constexpr unsigned first_signal_bit = 16;

/// The flags of a constellation: whether it is on, and its signals.
std::uint32_t gnss_flags(const GnssBlock& one, const UbloxSettings& settings) {
  auto flags = static_cast<std::uint32_t>(settings[one.item]);
  if (settings.model() == Model::m8) return flags | 1u << first_signal_bit;
  for (const auto& [item, place] : one.signals)
    flags |= static_cast<std::uint32_t>(settings[item]) << (first_signal_bit + place);
  return flags;
}

}  // namespace

Verdict UbloxDialogue::on_gnss(wire::Bytes payload) {
  constexpr std::size_t head = 4, block = 8;
  constexpr std::uint8_t m8_channels = 32, f9_channels = 60;
  const bool m8 = settings_.model() == Model::m8;
  if (payload.empty()) {
    std::array<std::uint8_t, head + block * gnss_blocks.size()> answer{};
    answer[1] = answer[2] = m8 ? m8_channels : f9_channels;
    answer[3] = static_cast<std::uint8_t>(gnss_blocks.size());
    for (std::size_t i = 0; i < gnss_blocks.size(); ++i) {
      const auto& one = gnss_blocks[i];
      const auto out = std::span(answer).subspan(head + block * i, block);
      out[0] = one.gnss;
      const auto& channels = m8 ? one.m8_channels : one.f9_channels;
      out[1] = channels[0];
      out[2] = channels[1];
      store_le<std::uint32_t>(out, 4, gnss_flags(one, settings_));
    }
    reply(ubx::cfg_gnss, answer);
    return Verdict::ack;
  }
  if (payload.size() < head || payload[0] != 0 || payload.size() != head + block * payload[3])
    return Verdict::nak;
  for (std::size_t at = head; at < payload.size(); at += block) {
    const auto one = std::ranges::find(gnss_blocks, payload[at], &GnssBlock::gnss);
    if (one == gnss_blocks.end()) continue;
    const auto flags = load_le<std::uint32_t>(payload, at + 4);
    put(one->item, flags & 1u);
    if (m8) continue;
    for (const auto& [item, place] : one->signals)
      put(item, flags >> (first_signal_bit + place) & 1u);
  }
  note_ = fmt::format("GPS {}", settings_[gps] ? "on" : "off");
  return Verdict::ack;
}

}  // namespace drydock::emulate::ublox
