#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <cmath>
#include <functional>
#include <iterator>

#include "drivers/bus/subscriber.hpp"
#include "drivers/host/rig_bus.hpp"
#include "drivers/io/until_stopped.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/json_lines.hpp"
#include "drivers/text/measurement_fields.hpp"
#include "hil/topic/topic.hpp"

namespace drydock::topic {
namespace {

constexpr std::string_view diagnostics = "diagnostics";

/// The device or the estimator of a name or a topic: `imu` and `/imu/data`, `/estimate/leveling`.
std::string source_of(std::string_view name) {
  if (name.starts_with('/')) {
    name.remove_prefix(1);
    if (constexpr std::string_view of_estimator = "estimate/"; name.starts_with(of_estimator))
      name.remove_prefix(of_estimator.size());
    name = name.substr(0, name.find('/'));
  }
  return std::string(name);
}

std::string_view to_string(bus::Level level) {
  switch (level) {
    case bus::Level::ok: return "ok";
    case bus::Level::warn: return "warn";
    case bus::Level::error: return "error";
    case bus::Level::stale: return "stale";
  }
  return {};
}

class BusEcho final : public bus::Receiver {
 public:
  /// `wanted`: a device, an estimator or "diagnostics"; empty: all.
  BusEcho(const rig_config::Rig& rig, std::string wanted, std::uint64_t most, std::FILE* out)
      : rig_(rig),
        estimators_(host::estimator_names(rig)),
        wanted_(std::move(wanted)),
        most_(most),
        lines_(out) {}

  void receive(const bus::Measurement& measurement) override {
    std::visit([&](const auto& m) { print(m); }, measurement);
  }
  void receive(const bus::Attitude& a, std::size_t estimator) override {
    const auto& name = estimators_[estimator];
    if (!takes(name)) return;
    line([&](text::JsonWriter& json) {
      json.field("estimator", std::string_view(name));
      json.field("type", std::string_view("attitude"));
      json.field("valid_at_s", measurement::seconds(a.valid_at.time_since_epoch()));
      json.field("roll_deg", wire::degrees(a.roll_rad));
      json.field("pitch_deg", wire::degrees(a.pitch_rad));
      json.field("heading_deg",
                 a.yaw_rad ? std::optional{wire::degrees(*a.yaw_rad)} : std::nullopt);
      json.field("roll_sigma_deg", wire::degrees(std::sqrt(a.covariance(0, 0))));
      json.field("pitch_sigma_deg", wire::degrees(std::sqrt(a.covariance(1, 1))));
    });
  }
  void receive(const bus::DeviceStatus& status) override {
    if (!takes(diagnostics)) return;
    line([&](text::JsonWriter& json) {
      json.field("type", diagnostics);
      json.field("name", std::string_view(status.name));
      json.field("level", to_string(status.level));
      json.field("message", std::string_view(status.message));
      for (const auto& [key, value] : status.values) json.field(key, std::string_view(value));
    });
  }
  bool flush() { return lines_.flush(); }
  bool full() const { return most_ > 0 && printed_ >= most_; }
  std::uint64_t printed() const { return printed_; }

 private:
  void print(const auto& m) {
    const auto& name = rig_.devices[m.origin.device].name;
    if (!takes(name)) return;
    line([&](text::JsonWriter& json) {
      json.field("device", std::string_view(name));
      json.field("type", type_of(m));
      json.field("valid_at_s", measurement::seconds(m.origin.valid_at.time_since_epoch()));
      json.field("received_at_s", measurement::seconds(m.origin.received_at.time_since_epoch()));
      json.fields(m);
    });
  }

  bool takes(std::string_view name) const {
    return !full() && (wanted_.empty() || wanted_ == name);
  }
  template <class Write>
  void line(Write write) {
    ++printed_;
    lines_.line(write);
  }

  const rig_config::Rig& rig_;
  std::vector<std::string> estimators_;
  std::string wanted_;
  std::uint64_t most_;
  text::JsonLines lines_;
  std::uint64_t printed_ = 0;
};

/// Takes from the bus whenever something has come, until the time is over, Ctrl-C, or enough.
void listen(bus::Subscriber& subscriber, BusEcho& echo, double duration_s) {
  boost::asio::io_context io{1};
  boost::asio::posix::stream_descriptor arrivals(io, subscriber.fd());
  io::UntilStopped until(io, duration_s, [&] { arrivals.cancel(); });
  std::function<void()> wait = [&] {
    arrivals.async_wait(boost::asio::posix::stream_descriptor::wait_read,
                        [&](const boost::system::error_code& ec) {
                          if (ec) return;
                          subscriber.take(echo);
                          if (!echo.flush() || echo.full()) return until.stop();
                          wait();
                        });
  };
  wait();
  io.run();
  arrivals.release();  // the subscriber closes it
}

/// What can be asked for.
std::vector<std::string> sources_of(const rig_config::Rig& rig) {
  std::vector<std::string> all;
  for (const auto& device : rig.devices) all.push_back(device.name);
  std::ranges::copy(host::estimator_names(rig), std::back_inserter(all));
  all.emplace_back(diagnostics);
  return all;
}

}  // namespace

int echo_bus(const rig_config::Rig& rig, const EchoOptions& options, std::FILE* out,
             std::FILE* err) {
  const std::string wanted = source_of(options.name);
  const auto sources = sources_of(rig);
  if (!wanted.empty() && std::ranges::find(sources, wanted) == sources.end()) {
    fmt::print(err, "topic: nothing of {} in {}; it has {}\n", options.name, rig.file,
               fmt::join(sources, ", "));
    return terminal::exit_usage;
  }
  const bus::Participant participant(static_cast<std::uint32_t>(rig.dds_domain), rig.dds_interface);
  bus::Subscriber subscriber(participant, host::bus_devices(rig),
                             {.estimators = host::estimator_names(rig), .diagnostics = true});
  BusEcho echo(rig, wanted, options.most, out);
  listen(subscriber, echo, options.duration_s);
  return terminal::exit_of(echo.printed() > 0 && echo.flush());
}

}  // namespace drydock::topic
