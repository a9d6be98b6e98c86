#include <memory>

#include "hil/bench/run.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"

namespace drydock::program {

void add_run(CLI::App& app, Command& command) {
  struct Arguments {
    std::string rig, faults, speed = "1";
    std::optional<std::uint64_t> seed;
    bench::RunOptions options;
    RealtimeOptions realtime;
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
      ->transform(running_time);
  sub->add_option("--seed", a->seed, "seed of all random errors; default that of the rig file")
      ->check(seed_number);
  add_faults_option(*sub, a->faults);
  sub->add_option("--speed", a->speed, "1: real time; max: lockstep in virtual time")
      ->check(CLI::IsMember({"1", "max"}))
      ->capture_default_str();
  sub->add_option("--json", a->options.json, "write the summary to this file");
  sub->add_option("--junit", a->options.junit,
                  "write what became of the rig's [[expect]] to this file, as JUnit XML");
  sub->add_option("--report", a->options.report, "write index.html with plots into this folder");
  sub->add_option("--record", a->options.record.path,
                  "record all bytes, frames, measurements and estimates to this MCAP file");
  add_recording(*sub, a->options.record);
  add_serve(*sub, a->options.serve);
  add_allow_faults(*sub, a->options.serve);
  add_allow_recording(*sub, a->options.serve);
  add_realtime(*sub, a->realtime);
  sub->add_flag("--expect-streaming", a->options.expect_streaming,
                "exit 1 when a device is not streaming at the end");
  sub->add_option("--expect-rms", a->options.expect_rms_deg,
                  "exit 1 when an attitude estimate is worse than this against the truth [deg RMS]")
      ->check(positive_number);
  sub->callback([a, &command] {
    command = [a] {
      auto rig = load_rig(a->rig, a->speed == "max" ? check::Use::lockstep : check::Use::real_time);
      add_faults(rig, a->faults);
      if (a->seed) rig.seed = *a->seed;
      a->options.lockstep = a->speed == "max";
      if (a->options.lockstep && !a->options.serve.address.empty())
        throw CLI::ValidationError("--serve", "shows a run in real time, not with --speed max");
      if (a->options.lockstep && a->realtime.wanted)
        throw CLI::ValidationError("--realtime", "not with --speed max, which waits for no clock");
      claim(a->realtime);
      return bench::run(rig, a->options);
    };
  });
}

}  // namespace drydock::program
