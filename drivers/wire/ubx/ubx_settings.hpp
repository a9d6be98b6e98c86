#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/ubx/ubx_frame.hpp"

/// The frames with which a host sets up a u-blox receiver, as class, id and payload. Sources:
/// u-blox 8 / M8 Receiver Description (UBX-13003221), F9 HPG 1.13 interface description
/// (UBX-18010854).
namespace drydock::wire::ubx {

/// Class in the high byte, id in the low one.
enum Id : std::uint16_t {
  ack_nak = 0x0500,
  ack_ack = 0x0501,
  cfg_prt = 0x0600,
  cfg_msg = 0x0601,
  cfg_rst = 0x0604,
  cfg_rate = 0x0608,
  cfg_cfg = 0x0609,
  cfg_sbas = 0x0616,
  cfg_nav5 = 0x0624,
  cfg_gnss = 0x063E,
  cfg_valset = 0x068A,
  cfg_valget = 0x068B,
  cfg_valdel = 0x068C,
  mon_ver = 0x0A04,
  mon_hw = 0x0A09,
  mon_hw2 = 0x0A0B,
  tim_tm2 = 0x0D03,
};

struct Packet {
  std::uint16_t class_and_id = 0;
  Bytes payload;
};

/// `frame` is a whole UBX frame.
inline Packet packet_of(Bytes frame) {
  return {load_be<std::uint16_t>(frame, 2), frame.subspan(header_size, frame.size() - overhead)};
}

/// The messages that a receiver sends by itself and whose rates CFG-MSG sets.
struct MessageName {
  std::uint16_t class_and_id;
  std::string_view name;
};
inline constexpr auto message_names = std::to_array<MessageName>({
    {0x0102, "NAV-POSLLH"},  {0x0103, "NAV-STATUS"},  {0x0104, "NAV-DOP"},
    {0x0106, "NAV-SOL"},     {0x0107, "NAV-PVT"},     {0x0112, "NAV-VELNED"},
    {0x0120, "NAV-TIMEGPS"}, {0x0121, "NAV-TIMEUTC"}, {0x0130, "NAV-SVINFO"},
    {0x0135, "NAV-SAT"},     {0x0143, "NAV-SIG"},     {0x0161, "NAV-EOE"},
    {0x0213, "RXM-SFRBX"},   {0x0215, "RXM-RAWX"},    {0x0A09, "MON-HW"},
    {0x0A0B, "MON-HW2"},     {0x0D03, "TIM-TM2"},     {0xF000, "GGA"},
    {0xF001, "GLL"},         {0xF002, "GSA"},         {0xF003, "GSV"},
    {0xF004, "RMC"},         {0xF005, "VTG"},         {0xF008, "ZDA"},
});

constexpr std::string_view name_of_message(std::uint16_t class_and_id) {
  for (const auto& each : message_names)
    if (each.class_and_id == class_and_id) return each.name;
  return {};
}
constexpr std::optional<std::uint16_t> message_named(std::string_view name) {
  for (const auto& each : message_names)
    if (each.name == name) return each.class_and_id;
  return {};
}

}  // namespace drydock::wire::ubx
