#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "drivers/host/drive.hpp"
#include "estimators/host/estimate.hpp"
#include "hil/bench/emulate.hpp"
#include "hil/bench/run.hpp"
#include "hil/check/check.hpp"
#include "hil/control/order_faults.hpp"
#include "hil/control/remote_faults.hpp"
#include "hil/program/commands.hpp"
#include "rig_config/load.hpp"

namespace drydock::program {

namespace {

/// ROS_DOMAIN_ID chooses the DDS domain, as in every ROS 2 program. It overrides the rig file.
void apply_environment(rig_config::Rig& rig) {
  const char* text = std::getenv("ROS_DOMAIN_ID");
  if (text == nullptr || *text == '\0') return;
  constexpr int highest_domain = 232;
  const std::string_view digits(text);
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), rig.dds_domain);
  if (error != std::errc{} || end != digits.data() + digits.size() || rig.dds_domain < 0 ||
      rig.dds_domain > highest_domain) {
    throw std::runtime_error(
        fmt::format("ROS_DOMAIN_ID is '{}'; allowed: 0 to {}", digits, highest_domain));
  }
}

}  // namespace

rig_config::Rig load_rig(const std::string& path) {
  auto rig = rig_config::load_rig(path, check::load_options());
  if (rig) {
    apply_environment(*rig);
    return std::move(*rig);
  }
  for (const auto& problem : rig.error()) fmt::print(stderr, "{}\n", to_string(problem));
  throw BadRig{};
}

void add_serve(CLI::App& sub, host::ServeOptions& serve, const std::string& more) {
  sub.add_option("--serve", serve.address,
                 "a page for browsers and the Foxglove protocol at PORT or ADDRESS:PORT; default "
                 "127.0.0.1:8765" +
                     more)
      ->expected(0, 1)
      ->default_str("127.0.0.1:8765");
  sub.add_option("--token", serve.token,
                 "that a viewer must name; one is made where the address is not loopback");
}

namespace {

void add_faults_option(CLI::App* sub, std::string& file) {
  sub->add_option("--faults", file, "file of blocks [[fault]], beside those of the rig");
}

void add_allow_faults(CLI::App& sub, host::ServeOptions& serve) {
  sub.add_flag("--allow-faults", serve.allow_faults,
               "viewers may set and clear faults of the emulated devices: docs/use/live.md")
      ->needs("--serve");
}

/// Faults for a page beside the drivers, when another program plays the devices: orders go to it.
host::BehindPage faults_behind_page(const rig_config::Rig& rig) {
  return [&rig](const boost::asio::any_io_executor& executor, host::RigViewer& viewer,
                host::Watchers& watchers) {
    const auto remote = std::make_shared<control::RemoteFaults>(executor, rig, watchers);
    viewer.add(control::fault_services(
        rig, [remote](const auto& order, auto answered) { remote->obey(order, answered); }));
    return [remote](measurement::Stamp now) { remote->tick(now); };
  };
}

void add_overwrite(CLI::App* sub, host::RecordOptions& record) {
  sub->add_flag("--overwrite", record.overwrite, "replace what is there");
}

void add_run(CLI::App& app, Command& command) {
  struct Arguments {
    std::string rig, faults, speed = "1";
    std::optional<std::uint64_t> seed;
    bench::RunOptions options;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub =
      app.add_subcommand("run", "Emulated devices, drivers and estimators of a rig, with a report");
  sub->footer(
      "Example: drydock run rig_config/rigs/demo.toml --for 60s --report out\n"
      "         drydock run rig_config/rigs/demo.toml --for 10min --speed max --json out.json\n"
      "         drydock run rig_config/rigs/demo.toml --for 60s --speed max --junit expects.xml");
  sub->add_option("RIG", a->rig, "rig file (TOML)")->required();
  sub->add_option("--for", a->options.duration_s,
                  "how long: 60s, 10min, 5.5h; default until Ctrl-C")
      ->transform(duration_text);
  sub->add_option("--seed", a->seed, "seed of all random errors; default that of the rig file");
  add_faults_option(sub, a->faults);
  sub->add_option("--speed", a->speed, "1: real time; max: lockstep in virtual time")
      ->check(CLI::IsMember({"1", "max"}))
      ->capture_default_str();
  sub->add_option("--json", a->options.json, "write the summary to this file");
  sub->add_option("--junit", a->options.junit,
                  "write what became of the rig's [[expect]] to this file, as JUnit XML");
  sub->add_option("--report", a->options.report, "write index.html with plots into this folder");
  sub->add_option("--record", a->options.record.path,
                  "record all bytes, frames, measurements and estimates to this MCAP file");
  add_overwrite(sub, a->options.record);
  add_serve(*sub, a->options.serve);
  add_allow_faults(*sub, a->options.serve);
  sub->add_flag("--expect-streaming", a->options.expect_streaming,
                "exit 1 when a device is not streaming at the end");
  sub->add_option(
      "--expect-rms", a->options.expect_rms_deg,
      "exit 1 when an attitude estimate is worse than this against the truth [deg RMS]");
  sub->callback([a, &command] {
    command = [a] {
      auto rig = load_rig(a->rig);
      control::add_faults(rig, a->faults);
      if (a->seed) rig.seed = *a->seed;
      a->options.lockstep = a->speed == "max";
      if (a->options.lockstep && !a->options.serve.address.empty())
        throw CLI::ValidationError("--serve", "shows a run in real time, not with --speed max");
      return bench::run(rig, a->options);
    };
  });
}

void add_emulate(CLI::App& app, Command& command) {
  struct Arguments {
    std::string rig, faults;
    double duration_s = 0;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub =
      app.add_subcommand("emulate", "The emulated devices of a rig, for any program to open");
  sub->footer("Example: drydock emulate rig_config/rigs/demo.toml");
  sub->add_option("RIG", a->rig, "rig file (TOML)")->required();
  sub->add_option("--for", a->duration_s, "how long: 60s, 10min, 5.5h; default until Ctrl-C")
      ->transform(duration_text);
  add_faults_option(sub, a->faults);
  sub->callback([a, &command] {
    command = [a] {
      auto rig = load_rig(a->rig);
      control::add_faults(rig, a->faults);
      return bench::emulate(rig, a->duration_s);
    };
  });
}

/// drive and record: run the drivers of a rig. `output` is the option that names the recording.
void add_drive_command(CLI::App& app, Command& command, const std::string& name,
                       const std::string& description, const std::string& example,
                       const std::string& output) {
  struct Arguments {
    std::string rig;
    host::DriveOptions options;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub = app.add_subcommand(name, description);
  sub->footer("Example: " + example);
  sub->add_option("RIG", a->rig, "rig file (TOML)")->required();
  sub->add_option("--for", a->options.duration_s,
                  "how long: 60s, 10min, 5.5h; default until Ctrl-C")
      ->transform(duration_text);
  sub->add_option(output, a->options.record.path, "the MCAP file")->required(name == "record");
  add_overwrite(sub, a->options.record);
  add_serve(*sub, a->options.serve);
  if (name == "drive") add_allow_faults(*sub, a->options.serve);
  sub->callback([a, &command] {
    command = [a] {
      const auto rig = load_rig(a->rig);
      if (a->options.serve.allow_faults) a->options.behind_page = faults_behind_page(rig);
      return host::drive(rig, a->options);
    };
  });
}

void add_estimate(CLI::App& app, Command& command) {
  struct Arguments {
    std::string rig;
    host::EstimateOptions options;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub = app.add_subcommand("estimate", "Estimators of a rig on the measurements of the bus");
  sub->footer(
      "Example, in three terminals: drydock emulate R.toml; drydock drive R.toml; drydock estimate "
      "R.toml");
  sub->add_option("RIG", a->rig, "rig file (TOML)")->required();
  sub->add_option("--for", a->options.duration_s,
                  "how long: 60s, 10min, 5.5h; default until Ctrl-C")
      ->transform(duration_text);
  sub->add_flag("--json", a->options.json_lines, "every estimate as a JSON line");
  sub->callback(
      [a, &command] { command = [a] { return host::estimate(load_rig(a->rig), a->options); }; });
}

void add_check(CLI::App& app, Command& command) {
  auto files = std::make_shared<std::vector<std::string>>();
  auto* sub = app.add_subcommand("check", "Check rig, mission, sensor and vehicle files");
  sub->footer("Example: drydock check rig_config/rigs/*.toml");
  sub->add_option("FILES", *files, "TOML files")->required();
  sub->callback([files, &command] { command = [files] { return check::check(*files, stdout); }; });
}

}  // namespace

void add_rig_commands(CLI::App& app, Command& command) {
  add_run(app, command);
  add_emulate(app, command);
  add_drive_command(app, command, "drive",
                    "The drivers of a rig: links in, measurements on the bus",
                    "drydock drive rig_config/rigs/demo.toml", "--record");
  add_drive_command(app, command, "record", "The drivers of a rig, and all they hear in a file",
                    "drydock record rig.toml -o dive.mcap --serve", "-o,--output");
  add_estimate(app, command);
  add_check(app, command);
}

}  // namespace drydock::program
