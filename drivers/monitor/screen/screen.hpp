#pragma once

#include "drivers/monitor/screen/canvas.hpp"
#include "drivers/monitor/screen/screen_state.hpp"

namespace drydock::monitor {

/// Lays out the screen of a monitor: title, a line for each device, the pane of the chosen one, the
/// keys. From 60 columns on nothing important is cut; the lines of the devices are always there.
Canvas draw_screen(const ScreenState& state, std::size_t width, std::size_t height);

}  // namespace drydock::monitor
