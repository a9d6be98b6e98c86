#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "drivers/wire/canopen/canopen_sdo.hpp"

namespace drydock::emulate {

/// What a master may set of a node's communication, other than its PDOs (CiA 301).
struct CanopenSettings {
  static constexpr std::uint32_t invalid_bit = 1U << 31, id_bits = 0x7FF;
  /// Object 1029h: what becomes of an operational node that has lost its master.
  static constexpr std::uint8_t to_pre_operational = 0, stays = 1, to_stopped = 2;

  std::uint32_t sync_id = 0x080;       ///< 1005h
  std::uint32_t emergency_id = 0x080;  ///< 1014h; bit 31: none
  std::uint32_t watched = 0;           ///< 1016h: a node << 16 and its longest silence in ms
  std::uint16_t guard_ms = 0;          ///< 100Ch
  std::uint16_t heartbeat_ms = 1000;   ///< 1017h; 0: none
  std::uint8_t life_factor = 0;        ///< 100Dh
  std::uint8_t when_lost = to_pre_operational;

  std::chrono::milliseconds patience() const { return std::chrono::milliseconds{watched & 0xFFFF}; }
  std::uint8_t watched_node() const { return static_cast<std::uint8_t>(watched >> 16); }
  std::chrono::milliseconds life() const {
    return std::chrono::milliseconds{guard_ms * life_factor};
  }
};

/// Empty: not an object of these.
std::optional<wire::canopen::SdoValue> read(const CanopenSettings& settings,
                                            const wire::canopen::ObjectEntry& entry);
/// Empty: not an object of these, or one that cannot be set; else the code of the refusal, 0 for
/// none.
std::optional<std::uint32_t> write(CanopenSettings& settings,
                                   const wire::canopen::SdoWrite& request);

}  // namespace drydock::emulate
