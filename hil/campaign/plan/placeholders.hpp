#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "hil/campaign/plan/plan.hpp"

/// Placeholders such as {speed} in the command and in the files of a campaign.
namespace drydock::campaign {

/// The names that stand for something.
std::vector<std::string> placeholder_names(const CampaignConfig& campaign);

/// The names in braces of `text` that stand for nothing.
std::vector<std::string> unknown_placeholders(const CampaignConfig& campaign,
                                              std::string_view text);

/// `text` for one run, whose own folder is `folder`. Braces around anything else stay.
std::string filled(const CampaignConfig& campaign, std::size_t index,
                   const std::filesystem::path& folder, std::string_view text);

/// The words of the command for one run. Blanks in a value do not split a word.
std::vector<std::string> command_of(const CampaignConfig& campaign, std::size_t index,
                                    const std::filesystem::path& folder);

/// Where a run leaves its figures if the command or a file of the campaign has {json}.
inline std::filesystem::path json_file(const std::filesystem::path& folder) {
  return folder / "figures.json";
}

}  // namespace drydock::campaign
