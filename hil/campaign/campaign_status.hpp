#pragma once

#include <cstdio>
#include <string>

#include "hil/campaign/campaign_options.hpp"
#include "hil/campaign/runs/ledger.hpp"

namespace drydock::campaign {

/// `3 of 10 runs, 1 failed, 2.00 runs/s, 4 s left` at a time in ms since 1970. The rate is that of
/// the last thousand runs; without two of them there is none.
std::string progress_text(const Ledger& ledger, std::size_t runs, std::int64_t now_ms);

/// Prints how far the campaign of the folder is. Exit code: 0; 2 if there is none.
int print_status(const CampaignOptions& options, std::FILE* out, std::FILE* errors);

}  // namespace drydock::campaign
