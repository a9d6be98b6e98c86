#include "hil/compare/compare.hpp"

#include <filesystem>
#include <memory>

#include "hil/program/capture_arguments.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"
#include "hil/program/part_arguments.hpp"
#include "rig_config/estimator/kinds.hpp"
#include "rig_config/toml/split_values.hpp"

namespace drydock::program {

namespace {

struct CompareArguments {
  compare::CompareOptions options;
  PartArguments part;
  std::string estimators;
};

std::string kinds_of_estimators() {
  std::string names;
  for (const auto& kind : rig_config::estimator_facts)
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
  return names;
}

void finish(CompareArguments& a) {
  for (const auto choice : rig_config::split_values(a.estimators, ','))
    a.options.estimators.emplace_back(choice);
  a.options.part = a.part.selection();
}

/// A file whose name does not end with .toml is no rig; its content tells a recording.
bool is_rig(const CompareArguments& a) {
  const auto& source = a.options.source;
  return source.ends_with(".toml") ||
         (a.options.capture.protocol.empty() && !std::filesystem::is_regular_file(source));
}

int run_compare(CompareArguments& a) {
  auto& capture = a.options.capture;
  capture.description = load_protocol(capture.protocol);
  if (!a.options.source.ends_with(".toml") && std::filesystem::exists(a.options.source))
    must_be_readable(a.options.source);
  if (!is_rig(a)) return compare::compare(nullptr, a.options, stdout, stderr);
  const auto rig = load_rig(a.options.source, check::Use::lockstep);
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
      "         drydock compare dive.pd0 --protocol pd0 --estimators dead-reckoning");
  sub->add_option("SOURCE", o.source,
                  "MCAP recording, capture of one sensor, or a rig, which runs in virtual time")
      ->required();
  sub->add_option("--estimators", a->estimators,
                  "A,B,C: names of the rig's estimators or kinds, out of " + kinds_of_estimators() +
                      "; each with options as kind:key=value:key=value")
      ->required();
  sub->add_option("--rig", o.rig,
                  "rig file in the place of the recorded one, or with the sensor of a capture")
      ->transform(rig_name);
  sub->add_option("--for", o.duration_s, "of a rig: 60s, 10min; default one lap of its mission")
      ->transform(running_time);
  a->part.add_only_and_from(*sub);
  a->part.add_to(*sub);
  add_capture(*sub, o.capture);
  sub->add_flag("--json", o.json, "one JSON object instead of a table");
  sub->add_option("--report", o.report, "write index.html with plots into this folder");
  sub->callback([a, &command] {
    finish(*a);
    command = [a] { return run_compare(*a); };
  });
}

}  // namespace drydock::program
