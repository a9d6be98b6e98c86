#include <memory>

#include "drivers/decode/decode.hpp"
#include "drivers/link/uri.hpp"
#include "hil/bridge/run_bridge.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"

namespace drydock::program {

namespace {

struct BridgeArguments {
  std::string spoken, source, protocol, messages = "position-delta";
  bridge::BridgeOptions options;
};

/// A rig with this one DVL.
rig_config::Rig rig_of_link(const BridgeArguments& a) {
  rig_config::DeviceConfig device;
  device.name = "dvl";
  device.kind = measurement::Kind::dvl;
  device.protocol = a.protocol;
  device.description = load_protocol(a.protocol);
  device.link = a.source;
  device.rate_hz = bridge::most_per_second;  // as many as may have to be sent
  rig_config::Rig rig;
  rig.devices.push_back(device);
  return rig;
}

}  // namespace

void add_bridge(CLI::App& app, Command& command) {
  auto a = std::make_shared<BridgeArguments>();
  auto* sub = app.add_subcommand("bridge", "The motion that a DVL measures, to an autopilot");
  sub->footer(
      "Example: drydock bridge mavlink rig.toml --to 'udp:0.0.0.0:14550?listen=1'\n"
      "         drydock bridge mavlink tcp:192.168.194.95:16171 --protocol water-linked-json "
      "--to 'serial:/dev/ttyACM0?baud=115200'");
  sub->add_option("PROTOCOL", a->spoken, "what the autopilot speaks")
      ->required()
      ->check(CLI::IsMember({"mavlink"}));
  sub->add_option("SOURCE", a->source, "rig file (TOML), or link URI of a DVL")->required();
  sub->add_option("--to", a->options.to,
                  "link URI of the autopilot: udp:HOST:PORT, tcp:HOST:PORT, serial:PATH?baud=57600")
      ->required();
  sub->add_option("--protocol", a->protocol,
                  "of a link: one of " + decode::decode_protocols() + "; or a description");
  sub->add_option("--device", a->options.device, "of a rig with several DVLs: its name");
  sub->add_option("--messages", a->messages,
                  "VISION_POSITION_DELTA (default), as ArduPilot takes a DVL, or ODOMETRY")
      ->check(CLI::IsMember({"position-delta", "odometry", "both"}));
  sub->add_option("--system", a->options.system, "MAVLink system of both; default 1")
      ->check(CLI::Range(1, 255));
  sub->add_option("--component", a->options.component,
                  "MAVLink component of this end; default 197, visual inertial odometry")
      ->check(CLI::Range(1, 255));
  sub->add_option("--for", a->options.duration_s, "how long: 60s, 10min; default until Ctrl-C")
      ->transform(running_time);
  sub->add_flag("--json", a->options.json, "the figures at the end as one JSON object");
  sub->callback([a, &command] {
    command = [a] {
      auto& options = a->options;
      options.rig = link::parse_uri(a->source) ? rig_of_link(*a) : load_rig(a->source);
      options.position_delta = a->messages != "odometry";
      options.odometry = a->messages != "position-delta";
      return bridge::bridge_mavlink(options, stdout, stderr);
    };
  });
}

}  // namespace drydock::program
