#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <functional>

#include "drivers/bus/subscriber.hpp"
#include "drivers/host/rig_bus.hpp"
#include "drivers/io/until_stopped.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/json_lines.hpp"
#include "drivers/text/measurement_fields.hpp"
#include "hil/topic/topic.hpp"

namespace drydock::topic {
namespace {

class BusEcho final : public bus::Receiver {
 public:
  BusEcho(const rig_config::Rig& rig, const EchoOptions& options, std::FILE* out)
      : rig_(rig), options_(options), lines_(out) {}

  using Receiver::receive;
  void receive(const bus::Measurement& measurement) override {
    if (full()) return;
    std::visit([&](const auto& m) { print(m); }, measurement);
  }
  bool flush() { return lines_.flush(); }
  bool full() const { return options_.most > 0 && printed_ >= options_.most; }
  std::uint64_t printed() const { return printed_; }

 private:
  void print(const auto& m) {
    const auto& name = rig_.devices[m.origin.device].name;
    if (!options_.name.empty() && name != options_.name) return;
    ++printed_;
    lines_.line([&](text::JsonWriter& json) {
      json.field("device", std::string_view(name));
      json.field("type", type_of(m));
      json.field("valid_at_s", measurement::seconds(m.origin.valid_at.time_since_epoch()));
      json.field("received_at_s", measurement::seconds(m.origin.received_at.time_since_epoch()));
      json.fields(m);
    });
  }

  const rig_config::Rig& rig_;
  const EchoOptions& options_;
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

bool has(const rig_config::Rig& rig, const std::string& device) {
  return std::ranges::find(rig.devices, device, &rig_config::DeviceConfig::name) !=
         rig.devices.end();
}

}  // namespace

int echo_bus(const rig_config::Rig& rig, const EchoOptions& options, std::FILE* out,
             std::FILE* err) {
  if (!options.name.empty() && !has(rig, options.name)) {
    fmt::print(err, "topic: {} has no device \"{}\"\n", rig.file, options.name);
    return terminal::exit_usage;
  }
  const bus::Participant participant(static_cast<std::uint32_t>(rig.dds_domain), rig.dds_interface);
  bus::Subscriber subscriber(participant, host::bus_devices(rig));
  BusEcho echo(rig, options, out);
  listen(subscriber, echo, options.duration_s);
  return terminal::exit_of(echo.printed() > 0 && echo.flush());
}

}  // namespace drydock::topic
