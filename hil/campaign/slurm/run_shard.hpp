#pragma once

#include <cstdio>

#include "hil/campaign/campaign_options.hpp"

namespace drydock::campaign {

/// The work of one task: its shard's runs that no journal of the shard has. So a task that is
/// queued again goes on where the one before ended. Exit code: 0 all were written down.
int run_shard(const CampaignOptions& options, std::FILE* errors);

}  // namespace drydock::campaign
