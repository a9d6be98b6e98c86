#pragma once

#include <cstdio>

#include "hil/campaign/campaign_folder.hpp"

/// `drydock campaign --engine slurm`.
namespace drydock::campaign {

/// Submits the missing runs as job arrays. Unless it is to `detach`, it waits for their end; Ctrl-C
/// then cancels the jobs. Returns false if there is nothing to merge yet. Throws std::runtime_error
/// with what Slurm says.
bool run_on_slurm(const OpenCampaign& campaign, const CampaignOptions& options, std::FILE* out,
                  std::FILE* errors);

/// Cancels the jobs of the campaign's folder. Exit code.
int cancel_campaign(const CampaignOptions& options, std::FILE* out, std::FILE* errors);

}  // namespace drydock::campaign
