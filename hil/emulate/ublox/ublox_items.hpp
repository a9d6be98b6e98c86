#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "rig_config/emulate.hpp"

/// The settings of an emulated u-blox receiver: one item for each value of the configuration
/// database of an F9 that this emulation has. The messages CFG-* of an M8 set the same items.
/// Sources: u-blox F9 HPG 1.13 interface description (UBX-18010854), u-blox 8 / M8 Receiver
/// Description (UBX-13003221).
namespace drydock::emulate::ublox {

using Model = rig_config::UbloxModel;

/// The index of an item. Those behind `first_rate` are rates of messages, five for each message,
/// and behind these stand the inert ones.
enum Item : std::size_t {
  baud,
  in_ubx,
  in_nmea,
  out_ubx,
  out_nmea,
  measure_ms,
  measures_per_epoch,
  time_reference,
  dynamic_model,
  fix_mode,
  fixed_altitude,
  altitude_variance,
  lowest_elevation,
  position_dop_mask,
  time_dop_mask,
  position_mask,
  time_mask,
  static_speed,
  correction_timeout,
  least_satellites,
  least_cno,
  static_distance,
  utc_standard,
  stationary_mode,
  gps,
  sbas,
  galileo,
  beidou,
  qzss,
  glonass,
  sbas_test,
  sbas_ranging,
  sbas_corrections,
  sbas_integrity,
  sbas_numbers,
  gps_l1,
  gps_l2,
  galileo_e1,
  galileo_e5b,
  beidou_b1,
  beidou_b2,
  qzss_l1,
  qzss_l2,
  glonass_l1,
  glonass_l2,
  sbas_l1,
  first_rate
};

/// The groups that CFG-CFG saves, clears and loads: bits of its masks.
enum Group : std::uint8_t { ports = 0, messages = 1, navigation = 3, receiver = 4 };

struct ItemFacts {
  std::uint32_t key;  ///< of the F9's database; 0: only CFG-* has it
  Group group;
  std::uint64_t m8, f9;           ///< value as delivered
  std::uint64_t least = 0, most;  ///< outside of them the receiver refuses
};

/// A message that the receiver can send by itself.
struct MessageFacts {
  std::uint16_t class_and_id;
  std::uint32_t key;      ///< of its rate on I2C; that of UART1 is the next one; 0: not on an F9
  std::uint8_t rate = 0;  ///< on UART1 as delivered
  bool on_m8 = true;
};

/// The ports in the order of CFG-MSG: I2C, UART1, UART2, USB, SPI.
inline constexpr std::size_t ports_of_a_message = 5, uart1 = 1;

std::span<const MessageFacts> message_facts();
std::size_t item_count();
/// Facts of an item, also of a message's rate.
ItemFacts facts_of(std::size_t item);

std::optional<std::size_t> item_of_key(std::uint32_t key);
/// Bytes of the value: the key says it.
std::size_t size_of_key(std::uint32_t key);

/// The rate of a message on a port. Empty: the model does not have the message.
std::optional<std::size_t> rate_item(std::uint16_t class_and_id, std::size_t port, Model model);

}  // namespace drydock::emulate::ublox
