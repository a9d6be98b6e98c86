#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "drivers/wire/can/can_frame.hpp"

/// Reports of adapters about their bus, between frames. The Linux driver slcan reads them since
/// 6.0. `sb256256` gives the controller's state (a active, w warning, p passive, b bus-off) with
/// its receive and transmit error counters. `e2bc` gives two kinds of error (a no acknowledge, b
/// bit 0, B bit 1, c CRC, f form, s stuffing, o O receive and transmit overrun).
namespace drydock::wire::slcan {

/// True if a line (without its CR) is such a report.
bool is_report(std::string_view line);

/// The line for an error frame (linux/can/error.h), including CR. Empty if there is none.
std::string report_of(const CanFrame& error_frame);

/// The error frame for a report. Empty for any other line. A controller that is active again was
/// restarted.
std::optional<CanFrame> error_frame_of(std::string_view line);

}  // namespace drydock::wire::slcan
