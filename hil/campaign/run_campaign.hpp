#pragma once

#include <cstdio>

#include "hil/campaign/campaign_options.hpp"

/// `drydock campaign`, on this machine or by Slurm.
namespace drydock::campaign {

/// Does the runs, merges them and writes the report. Exit code: 0 all runs have figures; 1 some do
/// not, or Ctrl-C ended it, or a file cannot be written; 2 wrong file or folder.
int run_campaign(const CampaignOptions& options, std::FILE* out, std::FILE* errors);

}  // namespace drydock::campaign
