#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>

#include "drivers/monitor/monitor.hpp"
#include "drivers/monitor/monitor_view.hpp"
#include "drivers/monitor/screen_show.hpp"

namespace drydock::monitor {

/// Shows views repeatedly until the duration is over or Ctrl-C. With `once` it shows them a single
/// time.
class MonitorLoop {
 public:
  /// `wire`: for the screen's raw bytes.
  MonitorLoop(const MonitorOptions& options, std::string title,
              std::function<std::vector<DeviceView>()> views, WireSource wire,
              Pane first = Pane::values);

  boost::asio::io_context& io() { return io_; }
  /// Serves a page of the monitored devices if the options ask for it; otherwise gives null. Prints
  /// its address on standard error.
  std::unique_ptr<host::RigViewer> serve(const host::Viewed& viewed);
  /// Calls `poll` 10 times a second. `stop` must let io() run out of work. Returns 0 if nothing
  /// was wrong at the end, else 1.
  int run(const std::function<void()>& poll, const std::function<void()>& stop);

 private:
  double longest_s() const;  ///< 0: until Ctrl-C
  bool over(const std::vector<DeviceView>& views) const;
  void open_screen();
  void show(const std::vector<DeviceView>& views);
  void show_end(const std::vector<DeviceView>& views) const;

  const MonitorOptions& options_;
  std::function<std::vector<DeviceView>()> views_;
  boost::asio::io_context io_{1};
  boost::asio::steady_timer timer_{io_};
  std::string title_;
  WireSource wire_;
  Pane first_;
  std::unique_ptr<ScreenShow> screen_;  ///< null: no terminal, or one that only prints lines
  int steps_ = 0;
};

}  // namespace drydock::monitor
