#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "drivers/decode/decode.hpp"
#include "drivers/doctor/doctor.hpp"
#include "drivers/monitor/monitor.hpp"
#include "drivers/probe/probe.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/completion.hpp"
#include "hil/program/man_page.hpp"

namespace drydock::program {

namespace {

void add_probe(CLI::App& app, Command& command) {
  struct Arguments {
    probe::ProbeOptions options;
    bool all = false;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub = app.add_subcommand(
      "probe", "Find out what is on a wire: baud rate, protocol, sensors; never writes unasked");
  sub->footer(
      "Example: drydock probe --all\n"
      "         drydock probe serial:/dev/ttyUSB0\n"
      "         drydock probe socketcan:can0 --for 10s --ask");
  auto* link = sub->add_option("LINK", a->options.link, "link URI; serial: needs no baud rate");
  auto* all = sub->add_flag("--all", a->all, "list serial ports and CAN interfaces");
  all->excludes(link);
  sub->add_option(
         "--for", a->options.duration_s,
         "at most how long: 10s, 1min; default 30s. A byte line that is certain ends sooner")
      ->transform(duration_text);
  sub->add_flag("--ask", a->options.ask,
                "may write: the questions that only read, listed in docs/pier/probe.md");
  sub->add_flag("--json", a->options.json, "one JSON object instead of text");
  sub->callback([a, &command] {
    command = [a] {
      if (a->all) return probe::probe_all("/", a->options.json, stdout);
      if (!a->options.link.empty()) return probe::probe(a->options, stdout, stderr);
      fmt::print(stderr, "probe: give a LINK, or --all\n");
      return terminal::exit_usage;
    };
  });
}

/// True for a rig file, false for a link.
bool is_rig(const std::string& source) { return source.ends_with(".toml"); }

std::vector<std::unique_ptr<device::Device>> devices_of(const rig_config::Rig& rig) {
  auto devices = shell::make_devices(rig);
  if (!devices) throw std::runtime_error(devices.error().message);
  return std::move(*devices);
}

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
      "of a link: each message as a JSON line; one of " + decode::decode_protocols());
  auto* once = sub->add_flag("--once", a->options.once,
                             "one table, as soon as all stream; exit 1 when one does not");
  auto* json =
      sub->add_flag("--json", a->options.json, "an object a device each second, JSON Lines");
  auto* bus = sub->add_flag("--bus", a->bus,
                            "of a rig whose drivers run elsewhere: from DDS, not from the ports");
  add_serve(*sub, a->options.serve);
  auto* serve = sub->get_option("--serve")->excludes(once);
  protocol->excludes(once)->excludes(json)->excludes(bus)->excludes(serve);
  sub->add_option("--for", a->options.duration_s, "how long: 60s, 10min; default until Ctrl-C")
      ->transform(duration_text);
  sub->callback([a, &command] {
    command = [a] {
      if (!a->options.protocol.empty()) return monitor::monitor_messages(a->options);
      if (!is_rig(a->options.link)) return monitor::monitor_link(a->options);
      const auto rig = load_rig(a->options.link);
      return a->bus ? monitor::monitor_bus(rig, a->options)
                    : monitor::monitor_devices(devices_of(rig), rig.name, a->options);
    };
  });
}

void add_doctor(CLI::App& app, Command& command) {
  struct Arguments {
    std::string rig;
    bool json = false;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub = app.add_subcommand(
      "doctor", "Is this machine fit for a rig? What is wrong, and the command that mends it");
  sub->footer("Example: drydock doctor rig_config/rigs/bench-serial.toml");
  sub->add_option("RIG", a->rig, "rig file: only what it uses; default the whole machine");
  sub->add_flag("--json", a->json, "one JSON object instead of text");
  sub->callback([a, &command] {
    command = [a] {
      return doctor::doctor(a->rig.empty() ? doctor::Needs{} : doctor::needs_of(load_rig(a->rig)),
                            a->json, stdout);
    };
  });
}

void add_completion(CLI::App& app, Command& command) {
  auto shell = std::make_shared<std::string>();
  auto* sub = app.add_subcommand("completion", "Print a completion script for a shell");
  sub->footer(
      "Example: source <(drydock completion bash)\n"
      "         drydock completion zsh > ~/.zfunc/_drydock");
  sub->add_option("SHELL", *shell, "which shell")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh"}));
  sub->callback([shell, &app, &command] {
    command = [shell, &app] {
      fmt::print("{}", *shell == "bash" ? bash_completion(app) : zsh_completion(app));
      return 0;
    };
  });
}

void add_man(CLI::App& app, Command& command) {
  auto* sub = app.add_subcommand("man", "Print the manual page, in roff");
  sub->footer("Example: drydock man | man -l -");
  sub->callback([&app, &command] {
    command = [&app] {
      fmt::print("{}", man_page(app, app.version()));
      return 0;
    };
  });
}

}  // namespace

void add_field_commands(CLI::App& app, Command& command) {
  add_probe(app, command);
  add_monitor(app, command);
  add_doctor(app, command);
  add_completion(app, command);
  add_man(app, command);
}

}  // namespace drydock::program
