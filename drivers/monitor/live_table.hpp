#pragma once

#include <deque>
#include <string>
#include <string_view>

#include "drivers/host/follower.hpp"
#include "drivers/monitor/monitor_view.hpp"
#include "drivers/shell/real_time.hpp"

namespace drydock::monitor {

/// Shows a run while it goes on. On a terminal it draws a table over itself. Elsewhere it prints
/// plain lines: one for each change of state, and one for each device every ten seconds.
class LiveTable final : public host::Follower {
 public:
  /// `start` is of link::steady_now(). `duration_s` 0: until Ctrl-C.
  LiveTable(const shell::RealTime& shell, Stamp start, double duration_s);

  void on_state(const device::Device& device, const device::Transition& change) override;
  void tick(Stamp now) override;  ///< draws the table
  void note(std::string line);
  void finish();

 private:
  void draw_table(double elapsed_s);
  void print_lines(double elapsed_s) const;

  const shell::RealTime& shell_;
  Stamp start_;
  double duration_s_;
  bool terminal_;
  Palette palette_;
  Overdrawn screen_;
  double next_lines_s_ = 10;
  std::deque<std::string> events_;
};

}  // namespace drydock::monitor
