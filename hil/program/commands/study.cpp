#include <memory>

#include "hil/program/commands.hpp"
#include "hil/program/options.hpp"
#include "hil/study/run/run_study.hpp"
#include "hil/study/velocity/velocity_study.hpp"

namespace drydock::program {

namespace {

std::string cases_of_velocity() {
  std::string names;
  for (const auto name : study::velocity_case_names())
    names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

}  // namespace

void add_study(CLI::App& app, Command& command) {
  auto options = std::make_shared<study::StudyOptions>();
  auto* sub =
      app.add_subcommand("study", "A paper's experiment again: its figures beside ours, many runs");
  sub->footer("Studies: " + study::study_names() +
              "\nExample: drydock study leveling --runs 100 --json leveling.json --report out");
  sub->add_option("NAME", options->name, "one of " + study::study_names())->required();
  sub->add_option("--runs", options->campaign.runs, "of the Monte Carlo experiment")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}))
      ->capture_default_str();
  sub->add_option("--seed", options->campaign.seed, "of every random number")
      ->capture_default_str()
      ->check(seed_number);
  sub->add_option("--jobs", options->campaign.jobs,
                  "threads; the result does not depend on it; default one a processor")
      ->check(CLI::Range(1U, 1024U));
  sub->add_option("--cases", options->campaign.cases,
                  "these experiments of the study alone: A,B; velocity has them, out of " +
                      cases_of_velocity())
      ->delimiter(',');
  sub->add_option("--registers", options->campaign.registers,
                  "velocity: the widest that hold runs side by side; the result does not depend on "
                  "it; default the widest of the processor")
      ->check(CLI::IsMember({"off", "avx2", "avx512"}));
  sub->add_option("--ephemeris", options->campaign.ephemeris,
                  "roll: GPS navigation file in place of that of 2010-07-01");
  sub->add_option("--json", options->json, "write the figures to this file");
  sub->add_option("--report", options->report, "write index.html with plots into this folder");
  sub->callback([options, &command] {
    command = [options] { return study::run_study(*options, stdout, stderr); };
  });
}

}  // namespace drydock::program
