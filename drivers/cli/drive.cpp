#include "drivers/cli/drive.hpp"

#include <fmt/format.h>

#include <boost/asio/signal_set.hpp>
#include <stdexcept>
#include <utility>

#include "drivers/bus/participant.hpp"
#include "drivers/cli/driver_host.hpp"
#include "drivers/cli/rig_bus.hpp"
#include "drivers/shell/rig_devices.hpp"

namespace drydock::cli {
namespace {

void print_state(const device::Device& device, const device::Transition& change) {
  fmt::print("{}: {} -> {}: {}\n", device.name(), to_string(change.from), to_string(change.to),
             change.why.view());
  std::fflush(stdout);
}

void print_health(const shell::RealTime& shell) {
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const auto h = shell.health(i);
    fmt::print("{}: {}, {:.2f} Hz of {:.1f}, {} messages, {} bytes skipped, {} bad checksums\n",
               shell.device(i).name(), to_string(h.state), h.rate_hz.value_or(0), h.nominal_rate_hz,
               h.messages, h.stream.bytes_skipped, h.stream.bad_checksums);
  }
}

}  // namespace

int drive(const rig_config::Rig& rig, double duration_s) {
  auto devices = shell::make_devices(rig);
  if (!devices) throw std::runtime_error(devices.error().message);
  boost::asio::io_context io{1};
  const bus::Participant participant(static_cast<std::uint32_t>(rig.dds_domain));
  bus::Publisher publisher(participant, bus_devices(rig));
  DriverHost host(io, std::move(*devices), &publisher);
  host.on_state_hook = print_state;

  bool stopped = false, all_streaming = false;
  boost::asio::signal_set signals(io, SIGINT, SIGTERM);
  boost::asio::steady_timer timer(io);
  const auto stop = [&](const boost::system::error_code& ec) {
    if (ec || std::exchange(stopped, true)) return;
    all_streaming = host.all_streaming();
    print_health(host.shell());
    host.on_state_hook = nullptr;
    signals.cancel();
    signals.clear();  // a second Ctrl-C ends the program at once
    timer.cancel();
    host.stop();
  };
  signals.async_wait([&](const boost::system::error_code& ec, int) { stop(ec); });
  if (duration_s > 0) {
    timer.expires_after(measurement::from_seconds(duration_s));
    timer.async_wait(stop);
  }
  host.start();
  io.run();
  return all_streaming ? 0 : 1;
}

}  // namespace drydock::cli
