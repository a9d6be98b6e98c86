#include "hil/bridge/run_bridge.hpp"

#include <fmt/format.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/steady_timer.hpp>

#include "drivers/device/news.hpp"
#include "drivers/host/driver_host.hpp"
#include "drivers/host/state_lines.hpp"
#include "drivers/io/until_stopped.hpp"
#include "drivers/link/link.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "hil/bridge/bridge_plan.hpp"
#include "hil/bridge/feed_report.hpp"
#include "hil/proxy/port.hpp"

namespace drydock::bridge {

namespace {

namespace asio = boost::asio;

constexpr std::chrono::seconds heartbeat_period{1};
/// What may wait for a slow link: two messages and a heartbeat.
constexpr std::size_t longest_queue = 512;

/// The drivers on one side, the autopilot's link on the other, the feed between them.
class Bridge final : private host::Follower {
 public:
  Bridge(asio::io_context& io, BridgePlan plan, std::FILE* err)
      : err_(err),
        state_lines_(err),
        autopilot_(io, plan.autopilot, link::Side::driver,
                   {[this](const wire::Bytes& bytes, Stamp) { return receive(bytes); },
                    [this](const device::Transition& change) { changed(change); },
                    {},
                    {}}),
        feed_(
            plan.feed, [this](wire::Bytes frame) { return send(frame); },
            [this](std::string_view line) { say(line); }),
        dvl_(plan.devices.front()->name()),
        host_(io, std::move(plan.devices), *this),
        heartbeat_(io) {
    host_.start();
    autopilot_.want(true);
    asio::co_spawn(io, autopilot_.serve(), asio::detached);
    beat();
  }

  void stop() {
    stopped_ = true;
    heartbeat_.cancel();
    host_.stop();
    autopilot_.finish();
  }

  const FeedCounters& counters() const { return feed_.counters(); }

 private:
  using Port = proxy::Port<link::ByteLink>;

  void on_measurement(const measurement::Measurement& measurement) override {
    feed_.on(measurement, link::now());
  }

  void on_state(const device::Device& device, const device::Transition& change) override {
    state_lines_.on_state(device, change);
    if (device.name() == dvl_ && change.from == device::State::streaming) feed_.on_silence();
  }

  bool send(wire::Bytes frame) {
    if (!autopilot_.is_open() || autopilot_.waiting() > longest_queue) return false;
    autopilot_.put(frame);
    return true;
  }

  Port::Run receive(wire::Bytes bytes) {
    feed_.receive(bytes, link::now());
    co_return;
  }

  void changed(const device::Transition& change) {
    const auto news = news_.tell(change);
    if (!news || stopped_) return;
    if (news->to == device::State::waiting) say("open");
    if (news->to == device::State::backing_off) say(news->why.view());
  }

  void say(std::string_view line) {
    fmt::print(err_, "{}: {}\n", autopilot_.uri().text, line);
    std::fflush(err_);
  }

  void beat() {
    feed_.beat();
    heartbeat_.expires_after(heartbeat_period);
    heartbeat_.async_wait([this](const boost::system::error_code& ec) {
      if (!ec && !stopped_) beat();  // an expired timer can no longer be cancelled
    });
  }

  std::FILE* err_;
  host::StateLines state_lines_;
  device::News news_;
  Port autopilot_;
  AutopilotFeed feed_;
  std::string dvl_;
  host::DriverHost host_;
  asio::steady_timer heartbeat_;
  bool stopped_ = false;
};

}  // namespace

int bridge_mavlink(const BridgeOptions& options, std::FILE* out, std::FILE* err) {
  auto plan = plan_of(options);
  if (!plan) {
    fmt::print(err, "bridge: {}\n", plan.error().message);
    return terminal::exit_usage;
  }
  asio::io_context io{1};
  Bridge bridge(io, std::move(*plan), err);
  io::UntilStopped until(io, options.duration_s, [&] { bridge.stop(); });
  io.run();
  const FeedCounters& counters = bridge.counters();
  fmt::print(out, "{}", options.json ? to_json(counters) : to_text(counters));
  return terminal::exit_of(counters.sent > 0);
}

}  // namespace drydock::bridge
