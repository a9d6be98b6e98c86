#include <algorithm>
#include <charconv>
#include <cmath>

#include "drivers/bus/subscriber.hpp"
#include "drivers/host/rig_bus.hpp"
#include "drivers/link/link.hpp"
#include "drivers/monitor/monitor_loop.hpp"

namespace drydock::monitor {
namespace {

/// Anybody can write anything to the bus. Text that is not a finite number gives no value.
template <class Number>
std::optional<Number> number_of(std::string_view text) {
  Number number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole && std::isfinite(static_cast<double>(number)) ? std::optional(number) : std::nullopt;
}

/// Turns diagnostics and measurements from the bus into views, and passes them on to the followers.
class BusViews final : public bus::Receiver {
 public:
  explicit BusViews(const rig_config::Rig& rig) {
    followers.add(latest_);
    for (const auto& device : rig.devices) {
      DeviceView view;
      view.name = device.name;
      view.link = device.link;
      view.protocol = device.protocol;
      view.kind = to_string(static_cast<device::Kind>(device.kind));
      view.nominal_rate_hz = device.rate_hz;
      view.state = "not heard";
      view.status = "no diagnostics on the bus: do its drivers run, in this DDS domain?";
      views_.push_back(std::move(view));
    }
  }

  host::Followers followers;

  using bus::Receiver::receive;
  void receive(const bus::Measurement& measurement) override {
    followers.on_measurement(measurement);
  }
  void receive(const bus::Attitude& attitude, std::size_t estimator) override {
    followers.on_estimate({.estimator = estimator, .attitude = attitude});
  }

  void receive(const bus::DeviceStatus& status) override {
    health_.push_back(status);
    const auto view = std::ranges::find(views_, status.name, &DeviceView::name);
    if (view == views_.end()) return;
    view->state = status.message;
    view->streaming = status.level == bus::Level::ok;
    view->status.clear();
    for (const auto& [key, value] : status.values) set(*view, key, value);
  }

  /// Tells the followers the diagnostics that came since the last call.
  void tell_health() {
    if (health_.empty()) return;
    followers.on_health(host::HealthReport([this] { return health_; }), link::now());
    health_.clear();
  }

  std::vector<DeviceView> current() const {
    std::vector<DeviceView> shown = views_;
    for (std::size_t i = 0; i < shown.size(); ++i)
      latest_.show(static_cast<std::uint16_t>(i), shown[i]);
    return shown;
  }

 private:
  std::vector<DeviceView> views_;
  Latest latest_;
  std::vector<bus::DeviceStatus> health_;

  static void set(DeviceView& view, std::string_view key, const std::string& value) {
    const auto maybe = number_of<double>(value);
    const auto count = number_of<std::uint64_t>(value).value_or(0);
    if (key == "rate_hz") view.rate_hz = maybe;
    if (key == "jitter_s") view.jitter_s = maybe;
    if (key == "longest_interval_s") view.longest_interval_s = maybe;
    if (key == "age_s") view.age_s = maybe;
    if (key == "messages") view.messages = count;
    if (key == "frames") view.frames = count;
    if (key == "bytes_in") view.bytes = count;
    if (key == "bytes_skipped") view.bytes_skipped = count;
    if (key == "bad_checksums") view.bad_frames = count;
    if (key == "reopened") view.reopened = count;
    if (key == "can_dropped") view.can_dropped = count;
    if (key == "error_frames") view.error_frames = count;
    if (key == "last_error") view.last_error = value;
    if (key == "status") view.status = value;
  }
};

}  // namespace

int monitor_bus(const rig_config::Rig& rig, const MonitorOptions& options) {
  const bus::Participant participant(static_cast<std::uint32_t>(rig.dds_domain), rig.dds_interface);
  bus::SubscriberOptions wanted;
  wanted.diagnostics = true;
  if (!options.serve.address.empty()) wanted.estimators = host::estimator_names(rig);
  bus::Subscriber subscriber(participant, host::bus_devices(rig), wanted);
  BusViews heard(rig);
  MonitorLoop loop(options, [&] { return heard.current(); });
  const auto viewer = loop.serve(host::viewed(rig));
  if (viewer) heard.followers.add(*viewer);
  return loop.run(
      [&] {
        subscriber.take(heard);
        heard.tell_health();
      },
      [&] {
        if (viewer) viewer->stop();
      });
}

}  // namespace drydock::monitor
