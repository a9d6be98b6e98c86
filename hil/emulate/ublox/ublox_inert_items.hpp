#pragma once

#include <span>

#include "hil/emulate/ublox/ublox_items.hpp"

/// Items of the F9's database that a host may set and read back, and that change nothing here:
/// other ports, corrections, the odometer, the interference monitor, messages that this receiver
/// does not send. Real receivers take them, and a host that is refused one gives up (F9 HPG 1.13
/// interface description, UBX-18010854; of an M8 UBX-13003221).
namespace drydock::emulate::ublox {

std::span<const ItemFacts> inert_items();

/// Messages that are never sent.
std::span<const MessageFacts> unsent_messages();

}  // namespace drydock::emulate::ublox
