#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "drivers/bus/subscriber.hpp"
#include "drivers/host/finding_status.hpp"
#include "drivers/host/rig_bus.hpp"
#include "drivers/host/told_status.hpp"
#include "drivers/link/link.hpp"
#include "drivers/monitor/monitor_loop.hpp"
#include "drivers/text/printable.hpp"

namespace drydock::monitor {
namespace {

/// Anybody can write anything to the bus. Text that is not a finite number gives no value.
void put(const std::string& text, std::string& into) { into = text; }
template <class Number>
void put(const std::string& text, std::optional<Number>& into) {
  Number number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  into = whole && std::isfinite(static_cast<double>(number)) ? std::optional(number) : std::nullopt;
}
template <class Number>
void put(const std::string& text, Number& into) {
  std::optional<Number> number;
  put(text, number);
  into = number.value_or(0);
}

/// What a device is, the rig file says, not the bus.
constexpr std::array<std::string_view, 6> of_the_rig{"name", "kind",       "protocol",
                                                     "link", "provenance", "nominal_rate_hz"};

/// Turns diagnostics and measurements from the bus into views, and passes them on to the followers.
class BusViews final : public bus::Receiver {
 public:
  BusViews(const rig_config::Rig& rig, DisplayUnits units) : units_(std::move(units)) {
    followers.add(latest_);
    for (const auto& device : rig.devices) {
      DeviceView view;
      view.name = device.name;
      view.link = device.link;
      view.protocol = device.protocol;
      view.kind = to_string(device.kind);
      view.provenance = to_string(host::provenance_of(device.link));
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
    if (const auto finding = host::finding_of(status)) return receive(*finding, status.level);
    if (const auto told = host::told_of(status)) return receive(*told);
    const auto view = std::ranges::find(views_, status.name, &DeviceView::name);
    if (view == views_.end()) return;
    view->state = status.message;
    view->streaming = status.level == bus::Level::ok;
    view->status.clear();
    for (const auto& [key, value] : status.values) set(*view, key, value);
  }

  void receive(const host::Told& told) {
    const auto view = std::ranges::find(views_, told.device, &DeviceView::name);
    if (view != views_.end()) view->told = text::printable(told.what);
  }

  /// A finding that is over does not hide a newer one of the same device.
  void receive(const diagnosis::FindingAccount& finding, bus::Level level) {
    const auto view = std::ranges::find(views_, finding.device, &DeviceView::name);
    if (view == views_.end()) return;
    if (level != bus::Level::ok)
      view->finding = finding;
    else if (view->finding && view->finding->cause == finding.cause)
      view->finding.reset();
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
      show_values(latest_, static_cast<std::uint16_t>(i), units_, shown[i]);
    return shown;
  }

 private:
  std::vector<DeviceView> views_;
  LastValues latest_;
  DisplayUnits units_;
  std::vector<bus::DeviceStatus> health_;

  static void set(device::HealthAccount& account, std::string_view key, const std::string& text) {
    visit_fields(account, [&](std::string_view name, auto& into) {
      if (name == key && std::ranges::find(of_the_rig, name) == of_the_rig.end()) put(text, into);
    });
  }
};

}  // namespace

int monitor_bus(const rig_config::Rig& rig, const MonitorOptions& options) {
  const bus::Participant participant(static_cast<std::uint32_t>(rig.dds_domain), rig.dds_interface);
  bus::SubscriberOptions wanted;
  wanted.diagnostics = true;
  if (!options.serve.address.empty()) wanted.estimators = host::estimator_names(rig);
  bus::Subscriber subscriber(participant, host::bus_devices(rig), wanted);
  BusViews heard(rig, options.units);
  MonitorLoop loop(
      options, rig.name, [&] { return heard.current(); },
      {.show = {}, .none = "no bytes here: the drivers that read them are another program's"});
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
