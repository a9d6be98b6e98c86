#include <memory>

#include "drivers/host/drive.hpp"
#include "drivers/monitor/hints/wire_hints.hpp"
#include "estimators/host/diagnostician_beside.hpp"
#include "hil/control/remote_faults.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"

namespace drydock::program {

namespace {

/// Faults for a page beside the drivers, when another program plays the devices: orders go to it.
host::BehindPage faults_behind_page(const rig_config::Rig& rig) {
  return [&rig](const boost::asio::any_io_executor& executor, host::RigViewer& viewer,
                host::Follower& others) {
    auto remote = std::make_shared<control::RemoteFaults>(executor, rig, others);
    viewer.add(control::fault_services(
        rig, [remote](const auto& order, auto answered) { remote->obey(order, answered); }));
    return remote;
  };
}

/// drive and record: run the drivers of a rig. `output` is the option that names the recording.
void add_drivers(CLI::App& app, Command& command, const std::string& name,
                 const std::string& description, const std::string& example,
                 const std::string& output) {
  struct Arguments {
    std::string rig;
    host::DriveOptions options;
    RealtimeOptions realtime;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub = app.add_subcommand(name, description);
  sub->footer("Example: " + example);
  sub->add_option("RIG", a->rig, "rig file (TOML)")->required();
  sub->add_option("--for", a->options.duration_s,
                  "how long: 60s, 10min, 5.5h; default until Ctrl-C")
      ->transform(running_time);
  sub->add_option(output, a->options.record.path, "the MCAP file")->required(name == "record");
  add_recording(*sub, a->options.record);
  add_serve(*sub, a->options.serve);
  add_realtime(*sub, a->realtime);
  if (name == "drive") add_allow_faults(*sub, a->options.serve);
  if (name == "drive") add_allow_recording(*sub, a->options.serve);
  sub->callback([a, &command] {
    command = [a] {
      const auto rig = load_rig(a->rig);
      claim(a->realtime);
      if (a->options.serve.allow_faults) a->options.behind_page = faults_behind_page(rig);
      a->options.beside = host::diagnostician_beside;
      a->options.hints = std::make_shared<monitor::WireHints>();
      return host::drive(rig, a->options);
    };
  });
}

}  // namespace

void add_drive(CLI::App& app, Command& command) {
  add_drivers(app, command, "drive", "The drivers of a rig: links in, measurements on the bus",
              "drydock drive rig_config/rigs/demo.toml", "--record");
}

void add_record(CLI::App& app, Command& command) {
  add_drivers(app, command, "record", "The drivers of a rig, and all they hear in a file",
              "drydock record rig.toml -o dive.mcap --serve", "-o,--output");
}

}  // namespace drydock::program
