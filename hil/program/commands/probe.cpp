#include <fmt/format.h>

#include <memory>

#include "drivers/probe/probe.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"

namespace drydock::program {

void add_probe(CLI::App& app, Command& command) {
  struct Arguments {
    probe::ProbeOptions options;
    bool all = false;
    std::vector<std::string> describe;
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
      ->transform(running_time);
  sub->add_flag("--ask", a->options.ask,
                "may write: the questions that only read, listed in docs/pier/probe.md");
  sub->add_option("--describe", a->describe,
                  "a description of a sensor, tried too; again for each: valeport-vat.toml")
      ->check(CLI::Validator(
          [](const std::string& name) {
            return rig_config::is_description(name) ? "" : "expected a file *.toml";
          },
          "FILE.toml"))
      ->allow_extra_args(false)
      ->take_all();
  sub->add_flag("--json", a->options.json, "one JSON object instead of text");
  sub->callback([a, &command] {
    command = [a] {
      if (a->all) return probe::probe_all("/", a->options.json, stdout);
      for (const auto& name : a->describe) {
        a->options.descriptions.push_back(load_protocol(name));
        if (a->options.descriptions.back()->kind) continue;
        fmt::print(stderr,
                   "probe: {}: [sensor] has no key 'kind', and the probe listens for kinds; "
                   "`drydock decode --protocol {}` reads its messages\n",
                   name, name);
        return terminal::exit_usage;
      }
      if (!a->options.link.empty()) return probe::probe(a->options, stdout, stderr);
      fmt::print(stderr, "probe: give a LINK, or --all\n");
      return terminal::exit_usage;
    };
  });
}

}  // namespace drydock::program
