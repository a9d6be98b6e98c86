#pragma once

#include <cstdio>
#include <optional>

#include "hil/campaign/campaign_options.hpp"
#include "hil/campaign/plan/campaign_file.hpp"

namespace drydock::campaign {

/// A campaign, and the folder that is its own.
struct OpenCampaign {
  CampaignConfig config;
  std::filesystem::path out;
};

/// Reads the campaign's file. Empty: it cannot be used, and `errors` has the lines that say why.
std::optional<CampaignConfig> read_campaign(const std::string& file, std::FILE* errors);

/// The same for who only looks at what its folder has: empty too if that has no runs of it.
std::optional<OpenCampaign> find_campaign(const CampaignOptions& options, std::FILE* errors);

/// The same with its folder, which is made if it is not there. Empty too if the folder holds
/// another campaign, or results of this one that --resume was not given for.
std::optional<OpenCampaign> open_campaign(const CampaignOptions& options, std::FILE* errors);

}  // namespace drydock::campaign
