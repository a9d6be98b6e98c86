#include <fmt/format.h>

#include "drivers/device/bus/can_error_text.hpp"
#include "drivers/host/driver_host.hpp"
#include "drivers/host/finding_log.hpp"
#include "drivers/host/rig_bus.hpp"
#include "drivers/link/can/can_interface.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/monitor/found_devices.hpp"
#include "drivers/monitor/frames/rig_wires.hpp"
#include "drivers/monitor/hints/shared_ports.hpp"
#include "drivers/monitor/hints/wire_hints.hpp"
#include "drivers/monitor/monitor_loop.hpp"
#include "drivers/monitor/told_by_bus.hpp"
#include "drivers/probe/probe_bus.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/wire/can/can_bits.hpp"

namespace drydock::monitor {
namespace {

using link::Stamp;

/// Counts the bits on each CAN bus and keeps the state of its controller, by the URI of its link.
class BusMeter final : public host::Follower {
 public:
  void on_frame(std::string_view link, shell::Direction, const wire::CanFrame& frame,
                Stamp) override {
    Bus& bus = bus_of(link);
    bus.bits += wire::wire_bits(frame);
    if (frame.error) bus.state = device::can_error_text(frame);
  }

  /// Puts the load of a bus into the view of a device on it. The load is a mean over at least a
  /// second, so it is steady.
  void show(Stamp now, DeviceView& view) {
    const auto found = buses_.find(view.link);
    if (found == buses_.end()) return;
    Bus& bus = found->second;
    const double elapsed_s = measurement::seconds(now - bus.since);
    if (elapsed_s >= 1) {
      bus.bits_per_second = static_cast<double>(bus.bits) / elapsed_s;
      bus.bits = 0;
      bus.since = now;
    }
    view.bits_per_second = bus.bits_per_second;
    if (bus.bits_per_second && bus.bitrate) view.bus_load = *bus.bits_per_second / *bus.bitrate;
    view.can_state = bus.state;
  }

 private:
  struct Bus {
    std::uint64_t bits = 0;
    Stamp since = link::steady_now();
    std::optional<double> bits_per_second;
    std::optional<unsigned> bitrate;
    std::string state;
  };

  Bus& bus_of(std::string_view link) {
    const auto found = buses_.find(link);
    if (found != buses_.end()) return found->second;
    Bus bus;
    const auto uri = link::parse_uri(link);
    if (uri) bus.bitrate = uri->bitrate();
    if (uri && uri->scheme == link::Scheme::socketcan) {
      if (const auto controller = link::find_can_interface(uri->target)) {
        if (controller->bitrate) bus.bitrate = controller->bitrate;
        bus.state = controller->state;
      }
    }
    return buses_.emplace(link, std::move(bus)).first->second;
  }

  std::map<std::string, Bus, std::less<>> buses_;
};

/// True for a CANopen node: its driver starts it.
bool starts_nodes(const device::Device& device) {
  const auto* protocol = wire::find_protocol(device.options().driver.protocol);
  return protocol != nullptr && protocol->network == wire::Network::canopen;
}

}  // namespace

int monitor_devices(std::vector<std::unique_ptr<device::Device>> devices,
                    const rig_config::Rig& rig, const MonitorOptions& options) {
  for (auto& device : devices)
    if (!options.start || !starts_nodes(*device)) device->listen_only();
  LastValues latest;
  RigWires wires;
  WireHints hints;
  SharedPorts ports;
  ToldByBus told(rig);
  for (const auto& device : devices) {
    wires.add(*device);
    hints.add(*device);
  }
  BusMeter meter;
  host::FindingLog findings;
  host::DriverHost* drivers = nullptr;
  const auto views_now = [&] {
    std::vector<DeviceView> views;
    const auto& shell = drivers->shell();
    for (std::size_t i = 0; i < shell.size(); ++i) {
      DeviceView view = view_of(shell.device(i), shell.health(i));
      show_values(latest, shell.device(i).index(), options.units, view);
      meter.show(link::steady_now(), view);
      view.hint = hints.hint(shell.device(i));
      view.told = told.of(view.name);
      view.shared_with = ports.others(shell.device(i).options().link);
      if (const auto* finding = findings.open(shell.device(i).index()))
        view.finding = diagnosis::account_of(*finding, view.name, Stamp{});
      views.push_back(std::move(view));
    }
    return views;
  };
  MonitorLoop loop(options, rig.name, views_now, {.show = [&](const DeviceView& view) {
                     return wires.show(view.link, view.protocol);
                   }});
  host::Followers followers;
  followers.add(latest);
  followers.add(wires);
  followers.add(hints);
  followers.add(meter);
  followers.add(findings);
  const auto viewer = loop.serve({rig.name, host::bus_devices(devices)});
  if (viewer) followers.add(*viewer);
  host::DriverHost host(loop.io(), std::move(devices), followers);
  drivers = &host;
  std::shared_ptr<host::Follower> beside;
  if (options.beside) followers.add(*(beside = options.beside(rig, host.devices(), followers)));
  host.start();
  return loop.run([&] { told.poll(); },
                  [&] {
                    host.stop();
                    if (viewer) viewer->stop();
                  });
}

int monitor_link(const MonitorOptions& options) {
  const probe::ProbeReport report = probe::find_sensors(options.link, 10);
  if (report.devices.empty()) {
    probe::print_text(report, stderr);
    fmt::print(stderr, "monitor: no sensor found; --protocol shows the messages of a protocol\n");
    return terminal::exit_failed;
  }
  auto devices = devices_of(report);
  const auto rig = host::rig_of(devices, options.link);
  return monitor_devices(std::move(devices), rig, options);
}

}  // namespace drydock::monitor
