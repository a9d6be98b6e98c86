#pragma once

#include <cstdio>

#include "hil/campaign/campaign_folder.hpp"

namespace drydock::campaign {

/// Merges what the folder has into results.sqlite, summary.json and index.html, and prints the
/// tables. Returns the exit code of run_campaign().
int finish_campaign(const OpenCampaign& campaign, const CampaignOptions& options, std::FILE* out,
                    std::FILE* errors);

}  // namespace drydock::campaign
