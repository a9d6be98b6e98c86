#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <stdexcept>

#include "drivers/diagnosis/monitors/device_monitor.hpp"
#include "drivers/host/driver_host.hpp"
#include "drivers/host/rig_bus.hpp"
#include "drivers/io/until_stopped.hpp"
#include "drivers/link/link.hpp"
#include "drivers/monitor/found_devices.hpp"
#include "drivers/monitor/hints/wire_hints.hpp"
#include "hil/diagnose/examination.hpp"
#include "hil/diagnose/sources.hpp"

namespace drydock::diagnose {
namespace {

constexpr double usual_s = 60;  ///< for a listening without an end
constexpr double probing_s = 10;

/// Drivers in real time and an examination that looks at them several times a second.
class Listening {
 public:
  Listening(const rig_config::Rig& rig, std::vector<std::unique_ptr<device::Device>> devices,
            const std::string& source, double duration_s, bool rates_stated)
      : examination_(rig, link::now(), duration_s > 0 ? duration_s : usual_s),
        host_(io_, std::move(devices), followers_),
        source_(source),
        duration_s_(duration_s),
        rates_stated_(rates_stated) {
    examination_.follow(followers_, host_.devices());
    for (const auto* device : host_.devices()) hints_.add(*device);
    followers_.add(hints_);
  }

  Outcome run() {
    io::UntilStopped until(io_, duration_s_, [this] { stop(); });
    host_.start();
    keep_looking();
    io_.run();
    return std::move(outcome_);
  }

 private:
  void keep_looking() {
    timer_.expires_after(diagnosis::look_period);
    timer_.async_wait([this](const boost::system::error_code& ec) {
      if (ec || stopped_) return;  // an expired timer can no longer be cancelled
      examination_.look(link::now());
      keep_looking();
    });
  }

  void stop() {
    stopped_ = true;
    const auto now = link::now();
    examination_.look(now);
    outcome_ = examination_.result(source_, now, true, true, rates_stated_);
    for (const auto* device : host_.devices())
      if (auto hint = hints_.hint(*device); !hint.empty())
        outcome_.hints[device->name()] = std::move(hint);
    timer_.cancel();
    host_.stop();
  }

  boost::asio::io_context io_{1};
  host::Followers followers_;
  Examination examination_;
  monitor::WireHints hints_;
  host::DriverHost host_;
  boost::asio::steady_timer timer_{io_};
  std::string source_;
  double duration_s_;
  bool rates_stated_;
  Outcome outcome_;
  bool stopped_ = false;
};

/// The probe then ends at once, and its note says why.
bool was_not_opened(const probe::ProbeReport& report) {
  return report.attempts.empty() && report.listened_s < probing_s / 2 && !report.notes.empty();
}

}  // namespace

Outcome listen_to(const rig_config::Rig& rig, std::vector<std::unique_ptr<device::Device>> devices,
                  const std::string& source, double duration_s, bool rates_stated) {
  for (auto& device : devices) device->listen_only();
  return Listening(rig, std::move(devices), source, duration_s, rates_stated).run();
}

Outcome listen_to_link(const std::string& link, double duration_s) {
  const auto report = probe::find_sensors(link, probing_s);
  auto devices = monitor::devices_of(report);
  if (!devices.empty()) {
    const auto rig = host::rig_of(devices, link);
    return listen_to(rig, std::move(devices), link, duration_s, false);
  }
  if (was_not_opened(report)) throw std::runtime_error(report.notes.back());
  Outcome nothing;
  nothing.source = link;
  nothing.circumstances.duration_s = report.listened_s;
  nothing.notes = report.notes;
  return nothing;
}

}  // namespace drydock::diagnose
