#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/device/device.hpp"
#include "drivers/monitor/device_view.hpp"
#include "drivers/monitor/values/last_values.hpp"

namespace drydock::monitor {

/// Fills a view from health. `values` and times stay empty.
DeviceView view_of(const device::Device& device, const device::Health& health);

/// Puts the values and the times of the newest measurement of a device into a view.
void show_values(const LastValues& last, std::uint16_t device, const DisplayUnits& units,
                 DeviceView& view);

/// Colours and bold text on a terminal. Nothing if the output is no terminal or NO_COLOR is set.
class Palette {
 public:
  explicit Palette(bool terminal);
  std::string state(std::string_view state, std::string_view text) const;

 private:
  bool colour_;
};

/// The line of a device. The table of a run uses it too.
std::string headline(const DeviceView& view, const Palette& palette);

/// All lines of the devices, for an output that is no screen.
std::vector<std::string> table_lines(const std::vector<DeviceView>& views);

/// Draws lines over the previous ones.
class Overdrawn {
 public:
  explicit Overdrawn(std::FILE* out) : out_(out) {}
  void draw(std::vector<std::string> lines);  ///< as many as the screen has rows
  void finish() { drawn_ = 0; }

 private:
  std::FILE* out_;
  std::size_t drawn_ = 0;
};

/// Prints one JSON object for each device: its health account, then the other fields of DeviceView.
void print_json(const std::vector<DeviceView>& views, std::FILE* out);

}  // namespace drydock::monitor
