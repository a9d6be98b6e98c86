#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "drivers/wire/can/can_frame.hpp"

/// What adapters tell of their bus between frames, as the Linux driver slcan reads it since 6.0:
/// `sb256256` the controller's state (a active, w warning, p passive, b bus-off) with its receive
/// and transmit error counters; `e2bc` two kinds of error (a no acknowledge, b bit 0, B bit 1,
/// c CRC, f form, s stuffing, o O receive and transmit overrun).
namespace drydock::wire::slcan {

/// Whether a line without its CR is such a report.
bool is_report(std::string_view line);

/// The line, CR included, that tells an error frame (linux/can/error.h); empty where there is none.
std::string report_of(const CanFrame& error_frame);

/// The error frame that a report stands for; nothing for any other line. A controller that is
/// active again was restarted.
std::optional<CanFrame> error_frame_of(std::string_view line);

}  // namespace drydock::wire::slcan
