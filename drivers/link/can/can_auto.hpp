#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// `can:auto?name=NAME`: an emulated bus on any machine. The device side takes the kernel's vcan
/// interface NAME, and makes it if it may. If that is impossible it makes an slcan bus with two
/// ptys: NAME for the drivers and NAME-tap for other programs. The driver side makes nothing. It
/// takes the interface if it exists and is up, otherwise the pty; so it always meets the device.
OpenedFrames open_can_auto(const asio::any_io_executor& executor, const Uri& uri, Side side);

}  // namespace drydock::link
