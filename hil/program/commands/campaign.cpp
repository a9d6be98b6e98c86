#include <memory>

#include "hil/campaign/campaign_status.hpp"
#include "hil/campaign/run_campaign.hpp"
#include "hil/campaign/slurm/slurm_engine.hpp"
#include "hil/program/commands.hpp"
#include "rig_config/shipped.hpp"

namespace drydock::program {

void add_campaign(CLI::App& app, Command& command) {
  struct Arguments {
    campaign::CampaignOptions options;
    std::string engine = "local";
    bool status = false, cancel = false;
  };
  auto a = std::make_shared<Arguments>();
  auto& o = a->options;
  auto* sub = app.add_subcommand(
      "campaign", "Many runs of any command with other values: distributions, worst runs, causes");
  sub->footer(
      "Example: drydock campaign rig_config/campaigns/turning.toml --out turning\n"
      "         drydock campaign rig_config/campaigns/turning.toml --out turning --status\n"
      "         drydock campaign rig_config/campaigns/turning.toml --out new --compare turning\n"
      "         drydock campaign rig_config/campaigns/leveling.toml --engine slurm --shard-runs "
      "10");
  sub->add_option("CAMPAIGN", o.file, "campaign file (TOML)")->required();
  sub->add_option("--out", o.out, "folder of the results; default the file's name.campaign");
  sub->add_option("--jobs", o.jobs,
                  "runs at a time; the result does not depend on it; default one a processor")
      ->check(CLI::Range(1U, 1024U));
  auto* resume = sub->add_flag("--resume", o.resume,
                               "keep the results of the folder; run what is missing or failed");
  sub->add_option("--compare", o.earlier, "folder of an earlier campaign: better, worse or same");
  auto* only = sub->add_option("--only", o.only, "this run alone, by its index; its files stay");
  auto* status = sub->add_flag("--status", a->status, "say how far it is, and the time left")
                     ->excludes(resume)
                     ->excludes(only);
  sub->add_option("--engine", a->engine, "who does the runs: this machine or Slurm's tasks")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  sub->add_option("--shard-runs", o.shard_runs,
                  "Slurm: runs of a task; default such that there are at most 1000 tasks")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}));
  sub->add_option("--sbatch", o.sbatch, "Slurm: further options of sbatch, in one word");
  sub->add_flag("--detach", o.detach, "Slurm: submit and do not wait");
  sub->add_flag("--cancel", a->cancel, "Slurm: end the tasks; what they did stays")
      ->excludes(status)
      ->excludes(resume)
      ->excludes(only);
  sub->add_option("--shards", o.shards)->group("");  // these two are for the tasks themselves
  sub->add_option("--shard", o.shard)->group("");
  sub->callback([a, sub, &command] {
    a->options.file = rig_config::find_shipped(a->options.file, rig_config::campaigns);
    a->options.slurm = a->engine == "slurm";
    if (!a->options.slurm)
      for (const char* option : {"--shard-runs", "--sbatch", "--detach"})
        if (sub->count(option) > 0) throw CLI::ValidationError(option, "needs --engine slurm");
    command = [a] {
      if (a->cancel) return campaign::cancel_campaign(a->options, stdout, stderr);
      return a->status ? campaign::print_status(a->options, stdout, stderr)
                       : campaign::run_campaign(a->options, stdout, stderr);
    };
  });
}

}  // namespace drydock::program
