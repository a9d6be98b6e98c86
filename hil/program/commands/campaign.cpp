#include <memory>

#include "hil/campaign/campaign_status.hpp"
#include "hil/campaign/run_campaign.hpp"
#include "hil/program/commands.hpp"

namespace drydock::program {

void add_campaign(CLI::App& app, Command& command) {
  struct Arguments {
    campaign::CampaignOptions options;
    bool status = false;
  };
  auto a = std::make_shared<Arguments>();
  auto& o = a->options;
  auto* sub = app.add_subcommand(
      "campaign", "Many runs of any command with other values: distributions, worst runs, causes");
  sub->footer(
      "Example: drydock campaign rig_config/campaigns/turning.toml --out turning\n"
      "         drydock campaign rig_config/campaigns/turning.toml --out turning --status\n"
      "         drydock campaign rig_config/campaigns/turning.toml --out new --compare turning");
  sub->add_option("CAMPAIGN", o.file, "campaign file (TOML)")->required();
  sub->add_option("--out", o.out, "folder of the results; default the file's name.campaign");
  sub->add_option("--jobs", o.jobs,
                  "runs at a time; the result does not depend on it; default one a processor")
      ->check(CLI::Range(1U, 1024U));
  auto* resume = sub->add_flag("--resume", o.resume,
                               "keep the results of the folder; run what is missing or failed");
  sub->add_option("--compare", o.earlier, "folder of an earlier campaign: better, worse or same");
  auto* only = sub->add_option("--only", o.only, "this run alone, by its index; its files stay");
  sub->add_flag("--status", a->status, "say how far the campaign is, and the time left")
      ->excludes(resume)
      ->excludes(only);
  sub->callback([a, &command] {
    command = [a] {
      return a->status ? campaign::print_status(a->options, stdout, stderr)
                       : campaign::run_campaign(a->options, stdout, stderr);
    };
  });
}

}  // namespace drydock::program
