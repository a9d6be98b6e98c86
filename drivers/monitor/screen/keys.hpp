#pragma once

#include "drivers/monitor/screen/screen_state.hpp"

namespace drydock::monitor {

enum class Key : std::uint8_t {
  character,
  up,
  down,
  left,
  right,
  page_up,
  page_down,
  tab,
  enter,
  escape,
  erase
};

/// Applies a key. Up and down choose the device, left and right a value or a frame, tab the pane.
void press(ScreenState& state, Key key, char character = 0);
/// Keeps what is chosen within what there is now.
void keep_inside(ScreenState& state);

}  // namespace drydock::monitor
