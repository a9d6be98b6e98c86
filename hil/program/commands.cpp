#include "hil/program/commands.hpp"

#include <array>

namespace drydock::program {

// A rig file and what it describes.
void add_run(CLI::App&, Command&);
void add_emulate(CLI::App&, Command&);
void add_drive(CLI::App&, Command&);
void add_record(CLI::App&, Command&);
void add_estimate(CLI::App&, Command&);
void add_check(CLI::App&, Command&);
void add_fault(CLI::App&, Command&);
void add_diagnose(CLI::App&, Command&);
void add_topic(CLI::App&, Command&);
void add_example(CLI::App&, Command&);
void add_new(CLI::App&, Command&);
// A wire, and the machine.
void add_decode(CLI::App&, Command&);
void add_probe(CLI::App&, Command&);
void add_describe(CLI::App&, Command&);
void add_monitor(CLI::App&, Command&);
void add_doctor(CLI::App&, Command&);
void add_completion(CLI::App&, Command&);
void add_man(CLI::App&, Command&);
void add_help(CLI::App&, Command&);
// Recordings.
void add_info(CLI::App&, Command&);
void add_export(CLI::App&, Command&);
void add_recover(CLI::App&, Command&);
void add_cut(CLI::App&, Command&);
void add_bisect(CLI::App&, Command&);
void add_replay(CLI::App&, Command&);
void add_diff(CLI::App&, Command&);
void add_track(CLI::App&, Command&);
void add_twin(CLI::App&, Command&);
void add_proxy(CLI::App&, Command&);
void add_bridge(CLI::App&, Command&);
// The emulated world and the papers, without wires.
void add_sensor(CLI::App&, Command&);
void add_sky(CLI::App&, Command&);
void add_maneuver(CLI::App&, Command&);
void add_study(CLI::App&, Command&);
void add_campaign(CLI::App&, Command&);
// Measuring sensors, drivers and the machine.
void add_characterize(CLI::App&, Command&);
void add_calibrate(CLI::App&, Command&);
void add_soak(CLI::App&, Command&);
void add_validity(CLI::App&, Command&);
void add_load(CLI::App&, Command&);
void add_scorecard(CLI::App&, Command&);
void add_score(CLI::App&, Command&);
void add_compare(CLI::App&, Command&);
void add_dds_config(CLI::App&, Command&);

std::span<const AddCommand> commands() {
  static constexpr auto all = std::to_array<AddCommand>(
      {add_run,       add_emulate,   add_drive,    add_record,  add_estimate,   add_check,
       add_fault,     add_diagnose,  add_topic,    add_example, add_new,        add_decode,
       add_probe,     add_describe,  add_monitor,  add_doctor,  add_completion, add_man,
       add_help,      add_info,      add_export,   add_recover, add_cut,        add_bisect,
       add_replay,    add_diff,      add_track,    add_twin,    add_proxy,      add_bridge,
       add_sensor,    add_sky,       add_maneuver, add_study,   add_campaign,   add_characterize,
       add_calibrate, add_soak,      add_validity, add_load,    add_scorecard,  add_score,
       add_compare,   add_dds_config});
  return all;
}

}  // namespace drydock::program
