#include "drivers/monitor/monitor_loop.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "drivers/io/until_stopped.hpp"
#include "drivers/terminal/exit_codes.hpp"

namespace drydock::monitor {
namespace {

constexpr std::chrono::milliseconds step_period{100};
constexpr int steps_a_second = 10, steps_a_draw = 5;
constexpr double longest_once_s = 10;

bool all_streaming(const std::vector<DeviceView>& views) {
  return !views.empty() && std::ranges::all_of(views, &DeviceView::streaming);
}

}  // namespace

MonitorLoop::MonitorLoop(const MonitorOptions& options,
                         std::function<std::vector<DeviceView>()> views)
    : options_(options),
      views_(std::move(views)),
      terminal_(::isatty(STDOUT_FILENO) == 1),
      table_(terminal_ && !options.once),
      screen_(stdout) {}

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

/// A rate needs a few messages. The loop takes no table before each device has its rate.
bool MonitorLoop::over(const std::vector<DeviceView>& views) const {
  return options_.once && all_streaming(views) &&
         std::ranges::all_of(views, [](const auto& v) { return v.rate_hz > 0 && v.jitter_s; });
}

void MonitorLoop::show(const std::vector<DeviceView>& views) {
  if (options_.once) return;
  if (options_.json) {
    if (steps_ % steps_a_second == 0) print_json(views, stdout);
  } else if (terminal_ && steps_ % steps_a_draw == 0) {
    screen_.draw(table_.lines(views));
  }
}

int MonitorLoop::run(const std::function<void()>& poll, const std::function<void()>& stop) {
  std::vector<DeviceView> last;
  bool due = false, ended = false;  // they outlive the last handler of the timers
  io::UntilStopped until(io_, longest_s(), [&] { ended = true; });
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
    ended = ended || over(last);
  }
  screen_.finish();
  until.stop();
  stop();
  io_.run();
  if (options_.json && options_.once) print_json(last, stdout);
  if (!options_.json && (options_.once || !terminal_))
    for (const auto& line : table_.lines(last)) fmt::print("{}\n", line);
  return terminal::exit_of(all_streaming(last));
}

}  // namespace drydock::monitor
