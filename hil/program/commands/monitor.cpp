#include <memory>
#include <stdexcept>

#include "drivers/decode/decode.hpp"
#include "drivers/monitor/monitor.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "estimators/host/diagnostician_beside.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/link_argument.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"

namespace drydock::program {

namespace {

std::vector<std::unique_ptr<device::Device>> devices_of(const rig_config::Rig& rig) {
  auto devices = shell::make_devices(rig);
  if (!devices) throw std::runtime_error(devices.error().message);
  return std::move(*devices);
}

void add_units(CLI::App& sub, monitor::DisplayUnits& units) {
  sub.add_option_function<std::string>(
      "--units",
      [&units](const std::string& names) {
        try {
          units = monitor::DisplayUnits::of(names);
        } catch (const std::invalid_argument& error) {
          throw CLI::ValidationError("--units", error.what());
        }
      },
      "of what people read, in place of the usual ones: kn,bar; out of " +
          monitor::DisplayUnits::allowed());
}

}  // namespace

void add_monitor(CLI::App& app, Command& command) {
  struct Arguments {
    monitor::MonitorOptions options;
    bool bus = false;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub = app.add_subcommand(
      "monitor", "Show what a rig's devices, or a link, say now; never writes to the wire");
  sub->footer(
      "Example: drydock monitor rig_config/rigs/bench-serial.toml\n"
      "         drydock monitor serial:/dev/ttyUSB0 --once\n"
      "         drydock monitor serial:/dev/ttyUSB0 --serve\n"
      "         drydock monitor 'serial:/dev/ttyUSB0?baud=38400' --protocol ubx");
  sub->add_option("SOURCE", a->options.link,
                  "rig file (TOML), or link URI: its sensors are found by probing")
      ->required();
  auto* protocol = sub->add_option(
      "--protocol", a->options.protocol,
      "of a link: its frames, or without a terminal each message as a JSON line; one of " +
          decode::decode_protocols() + "; or a description: valeport-vat.toml");
  auto* once = sub->add_flag(
      "--once", a->options.once,
      "one table, as soon as all is well, or after 10 s; exit 1 when something is wrong");
  auto* json =
      sub->add_flag("--json", a->options.json, "an object a device each second, JSON Lines");
  auto* bus = sub->add_flag("--bus", a->bus,
                            "of a rig whose drivers run elsewhere: from DDS, not from the ports");
  auto* start = sub->add_flag("--start", a->options.start,
                              "start CANopen nodes, as drive does; this alone writes to the wire");
  protocol->excludes(start);
  add_units(*sub, a->options.units);
  add_serve(*sub, a->options.serve);
  auto* serve = sub->get_option("--serve")->excludes(once);
  protocol->excludes(once)->excludes(json)->excludes(bus)->excludes(serve);
  sub->add_option("--for", a->options.duration_s, "how long: 60s, 10min; default until Ctrl-C")
      ->transform(running_time);
  sub->callback([a, &command] {
    command = [a] {
      a->options.description = load_protocol(a->options.protocol);
      if (!names_rig(a->options.link)) must_name_link("monitor", a->options.link);
      if (!a->options.protocol.empty()) return monitor::monitor_messages(a->options);
      a->options.beside = host::diagnostician_beside;
      if (!names_rig(a->options.link)) return monitor::monitor_link(a->options);
      const auto rig = load_rig(a->options.link);
      return a->bus ? monitor::monitor_bus(rig, a->options)
                    : monitor::monitor_devices(devices_of(rig), rig, a->options);
    };
  });
}

}  // namespace drydock::program
