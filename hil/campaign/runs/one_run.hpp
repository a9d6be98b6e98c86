#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "hil/campaign/plan/campaign_file.hpp"
#include "hil/campaign/runs/record.hpp"

namespace drydock::campaign {

/// Does one run in a folder of its own, which exists. Its files stay there. Empty: it was
/// ended from outside, so it was not done. The exit codes 0 and 1 both leave figures: a study or a
/// soak that says FAIL has measured. Any other exit, and a figure that is not there, is a failure.
std::optional<Record> do_run(const CampaignConfig& campaign, std::size_t index,
                             const std::filesystem::path& folder,
                             const std::function<bool()>& stopped);

}  // namespace drydock::campaign
