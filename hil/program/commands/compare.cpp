#include "hil/compare/compare.hpp"

#include <filesystem>
#include <memory>

#include "hil/program/commands.hpp"
#include "hil/program/dive_arguments.hpp"
#include "hil/program/load_rig.hpp"
#include "rig_config/estimator/kinds.hpp"
#include "rig_config/toml/split_values.hpp"

namespace drydock::program {

namespace {

struct CompareArguments {
  compare::CompareOptions options;
  DiveArguments dive;
  std::string estimators;
};

std::string kinds_of_estimators() {
  std::string names;
  for (const auto& kind : rig_config::estimator_facts)
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
  return names;
}

/// A file whose name does not end with .toml is no rig; its content tells a recording.
bool is_rig(const CompareArguments& a) {
  const auto& source = a.dive.files.front();
  return a.dive.files.size() == 1 &&
         (source.ends_with(".toml") ||
          (a.options.source.protocol.empty() && !std::filesystem::exists(named_file(source).path)));
}

void finish(CompareArguments& a) {
  for (const auto choice : rig_config::split_values(a.estimators, ','))
    a.options.estimators.emplace_back(choice);
  a.dive.read(a.options);
}

int run_compare(CompareArguments& a) {
  if (!is_rig(a)) {
    a.dive.open(a.options);
    return compare::compare(nullptr, a.options, stdout, stderr);
  }
  const auto rig = load_rig(a.options.source.capture, check::Use::lockstep);
  return compare::compare(&rig, a.options, stdout, stderr);
}

}  // namespace

void add_compare(CLI::App& app, Command& command) {
  auto a = std::make_shared<CompareArguments>();
  auto& o = a->options;
  auto* sub = app.add_subcommand(
      "compare", "Estimators side by side on the same bytes: errors, consistency, cost, gaps");
  sub->footer(
      "Example: drydock compare rig_config/rigs/demo.toml --estimators "
      "leveling,leveling:filter=robust,mixing --for 5min\n"
      "         drydock compare dive.mcap --estimators navigation,dead-reckoning --report out\n"
      "         drydock compare dive.mcap --estimators leveling,mixing --json\n"
      "         drydock compare dive.pd0 --protocol pd0 --estimators dead-reckoning\n"
      "         drydock compare dvl=dive.pd0 can.asc --rig my-rig.toml --estimators "
      "dead-reckoning,navigation");
  sub->add_option(
         "SOURCE", a->dive.files,
         "MCAP recording, or a rig, which runs in virtual time, or captures: of one sensor, "
         "or with --rig of several, where NAME=FILE names the device that reads it")
      ->required();
  sub->add_option("--estimators", a->estimators,
                  "A,B,C: names of the rig's estimators or kinds, out of " + kinds_of_estimators() +
                      "; each with options as kind:key=value:key=value")
      ->required();
  sub->add_option("--for", o.duration_s, "of a rig: 60s, 10min; default one lap of its mission")
      ->transform(running_time);
  a->dive.add_rig_and_part(*sub, o.rig);
  add_capture(*sub, o.source);
  sub->add_flag("--json", o.json, "one JSON object instead of a table");
  sub->add_option("--report", o.report, "write index.html with plots into this folder");
  sub->callback([a, &command] {
    finish(*a);
    command = [a] { return run_compare(*a); };
  });
}

}  // namespace drydock::program
