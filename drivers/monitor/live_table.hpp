#pragma once

#include <deque>
#include <string>
#include <string_view>

#include "drivers/device/life_cycle.hpp"
#include "drivers/monitor/monitor_view.hpp"
#include "drivers/shell/real_time.hpp"

namespace drydock::monitor {

/// Shows a run while it goes on. On a terminal it draws a table over itself. Elsewhere it prints
/// plain lines: one for each change of state, and one for each device every ten seconds.
class LiveTable {
 public:
  LiveTable();

  void note(std::string_view device, const device::Transition& change);
  void note(std::string line);
  void draw(const shell::RealTime& shell, double elapsed_s, double duration_s);
  void finish();

 private:
  void draw_table(const shell::RealTime& shell, double elapsed_s, double duration_s);
  void print_lines(const shell::RealTime& shell, double elapsed_s) const;

  bool terminal_;
  Palette palette_;
  Overdrawn screen_;
  double next_lines_s_ = 10;
  std::deque<std::string> events_;
};

}  // namespace drydock::monitor
