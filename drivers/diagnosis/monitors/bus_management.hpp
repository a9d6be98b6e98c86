#pragma once

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/j1939/j1939.hpp"
#include "drivers/wire/protocols.hpp"

namespace drydock::diagnosis {

/// Frames by which nodes settle their addresses and states. They come at any time.
inline bool manages(const wire::CanFrame& frame, wire::Network network) {
  if (network == wire::Network::j1939) {
    if (!frame.extended) return false;
    const auto pgn = wire::j1939::parse_identifier(frame.id).pgn;
    return pgn == wire::j1939::address_claim_pgn || pgn == wire::j1939::request_pgn;
  }
  // CiA 301: NMT 000h is the only one that a babbling node also uses, so it is none of these.
  const std::uint32_t function = frame.id & 0x780;
  return network == wire::Network::canopen && !frame.extended &&
         (function == 0x080 || function == 0x580 || function == 0x600 || function == 0x700);
}

}  // namespace drydock::diagnosis
