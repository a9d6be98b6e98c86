#pragma once

#include "drivers/monitor/screen/pane_line.hpp"
#include "drivers/monitor/screen/screen_state.hpp"

namespace drydock::monitor {

/// Troubles first, then every field of the chosen device, then its times and counts.
std::vector<PaneLine> values_pane(const ScreenState& state, std::size_t width);
/// The chosen value of the last five minutes; the components of a vector are x, y and z.
std::vector<PaneLine> plot_pane(const ScreenState& state, std::size_t width, std::size_t height);
/// The kinds of frames on the wire; the chosen one as hex with its fields beside it.
std::vector<PaneLine> raw_pane(const ScreenState& state, std::size_t width, std::size_t height);

}  // namespace drydock::monitor
