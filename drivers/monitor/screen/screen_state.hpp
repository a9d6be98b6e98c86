#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "drivers/monitor/device_view.hpp"
#include "drivers/monitor/screen/history.hpp"
#include "drivers/monitor/screen/shown_frame.hpp"

namespace drydock::monitor {

/// What the lower part of the screen shows of the chosen device.
enum class Pane : std::uint8_t { values, plot, raw };

/// What a person chose with the keys.
struct Choice {
  std::size_t device = 0;
  std::size_t item = 0;    ///< of the pane: among the values, or among the frames
  std::size_t scroll = 0;  ///< lines of the pane that are above it
  Pane pane = Pane::values;
  std::string filter{};  ///< shows only values and frames that contain it; small letters match both
  bool typing = false;   ///< keys go into the filter
  bool over = false;     ///< the person wants to leave
};

/// All that a screen is made of.
struct ScreenState {
  std::string title;  ///< of the rig or the link
  double now_s = 0;   ///< UTC since 1970
  std::vector<DeviceView> devices;
  ShownWire wire;       ///< of the chosen device
  std::string no_wire;  ///< why there are no bytes to show, in words; empty: there may be
  const History* history = nullptr;  ///< null: nothing is plotted
  Choice choice;
};

bool passes(const std::string& filter, const std::string& text);
/// The values of the chosen device that the filter lets through.
std::vector<const ShownValue*> chosen_values(const ScreenState& state);
/// The frames on its wire that the filter lets through: by name, bytes in hex, and field names.
std::vector<const ShownFrame*> chosen_frames(const ScreenState& state);

}  // namespace drydock::monitor
