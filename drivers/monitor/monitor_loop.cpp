#include "drivers/monitor/monitor_loop.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "drivers/io/until_stopped.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/monitor/problems.hpp"
#include "drivers/terminal/exit_codes.hpp"

namespace drydock::monitor {
namespace {

constexpr std::chrono::milliseconds step_period{100};
constexpr int steps_a_second = 10, steps_a_draw = 5, steps_a_table = 50;
constexpr double longest_once_s = 10;

void print_table(const std::vector<DeviceView>& views) {
  for (const auto& line : table_lines(views)) fmt::print("{}\n", line);
  std::fflush(stdout);
}

}  // namespace

MonitorLoop::MonitorLoop(const MonitorOptions& options, std::string title,
                         std::function<std::vector<DeviceView>()> views, WireSource wire,
                         Pane first)
    : options_(options),
      views_(std::move(views)),
      title_(std::move(title)),
      wire_(std::move(wire)),
      first_(first) {}

std::unique_ptr<host::RigViewer> MonitorLoop::serve(const host::Viewed& viewed) {
  if (options_.serve.address.empty()) return nullptr;
  auto viewer = std::make_unique<host::RigViewer>(io_.get_executor(), viewed, options_.serve);
  fmt::print(stderr, "live: {}\n", viewer->url());
  return viewer;
}

double MonitorLoop::longest_s() const {
  if (options_.duration_s > 0) return options_.duration_s;
  return options_.once ? longest_once_s : 0;
}

/// A rate needs a few messages. The loop takes no table before each device has its rate, and its
/// first values: over the bus they come apart. A fault is not judged by a few messages either, for
/// one pause of a busy host makes three of them look slow.
bool MonitorLoop::over(const std::vector<DeviceView>& views) const {
  return options_.once && all_well(views) && std::ranges::all_of(views, [](const auto& v) {
           return v.rate_hz > 0 && v.jitter_s && !v.values.empty();
         });
}

/// After UntilStopped: ncurses takes no signal that somebody waits for.
void MonitorLoop::open_screen() {
  if (options_.once || options_.json) return;
  auto terminal = CursesTerminal::open();
  if (!terminal) return;
  screen_ = std::make_unique<ScreenShow>(std::move(terminal), title_, wire_);
  screen_->choice().pane = first_;
}

void MonitorLoop::show(const std::vector<DeviceView>& views) {
  if (options_.once) return;
  if (options_.json) {
    if (steps_ % steps_a_second == 0) print_json(views, stdout);
  } else if (screen_) {
    if (steps_ % steps_a_draw == 0)
      screen_->show(views, measurement::seconds(link::now().time_since_epoch()));
  } else if (::isatty(STDOUT_FILENO) == 1 && steps_ % steps_a_table == 0) {
    print_table(views);
  }
}

void MonitorLoop::show_end(const std::vector<DeviceView>& views) const {
  if (options_.json && options_.once) print_json(views, stdout);
  if (!options_.json) print_table(views);
}

int MonitorLoop::run(const std::function<void()>& poll, const std::function<void()>& stop) {
  std::vector<DeviceView> last;
  bool due = false, ended = false;  // they outlive the last handler of the timers
  io::UntilStopped until(io_, longest_s(), [&] { ended = true; });
  open_screen();
  while (!ended) {
    timer_.expires_after(step_period);
    due = false;
    timer_.async_wait([&](const boost::system::error_code&) { due = true; });
    while (!due && !ended) io_.run_one();
    timer_.cancel();
    ++steps_;
    poll();
    last = views_();
    show(last);
    ended = ended || over(last) || (screen_ && !screen_->take_keys());
  }
  screen_.reset();
  until.stop();
  stop();
  io_.run();
  show_end(last);
  return terminal::exit_of(all_well(last));
}

}  // namespace drydock::monitor
