#pragma once

#include <cstddef>
#include <span>

#include "hil/campaign/plan/campaign_file.hpp"
#include "hil/campaign/runs/journal.hpp"
#include "hil/study/campaign.hpp"

namespace drydock::campaign {

/// Does these runs with `jobs` programs at a time, and writes each down as it ends. `progress`
/// ends it at once: runs that have begun are ended and not written down. Returns the number of runs
/// that were written down. Throws std::runtime_error if the journal cannot be written; what it has
/// stays.
std::size_t run_here(const CampaignConfig& campaign, std::span<const std::size_t> indexes,
                     unsigned jobs, Journal& journal, study::Progress& progress);

}  // namespace drydock::campaign
