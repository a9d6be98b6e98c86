#pragma once

#include "drivers/monitor/screen/canvas.hpp"
#include "drivers/monitor/screen/screen_state.hpp"

namespace drydock::monitor {

/// The style of a device's state.
Style style_of(const DeviceView& device);

/// Draws the column heads and a line for each device from `row` on, at most `most` lines around the
/// chosen one. Gives the first row behind them.
std::size_t draw_devices(Canvas& canvas, const ScreenState& state, std::size_t row,
                         std::size_t most);

}  // namespace drydock::monitor
