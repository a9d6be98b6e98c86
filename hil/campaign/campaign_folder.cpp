#include "hil/campaign/campaign_folder.hpp"

#include <fmt/format.h>

#include "hil/campaign/report/results.hpp"
#include "hil/report/write_file.hpp"
#include "rig_config/toml/checked_file.hpp"

namespace drydock::campaign {
namespace {

namespace fs = std::filesystem;

bool holds_another(const CampaignConfig& config, const fs::path& out) {
  const auto known = rig_config::read_file(campaign_copy(out).string());
  return known && *known != config.text;
}

/// What speaks against the use of this folder.
std::optional<std::string> objection(const CampaignConfig& config, const fs::path& out,
                                     bool resume) {
  if (!fs::exists(campaign_copy(out))) return {};
  if (holds_another(config, out))
    return "holds another campaign, or this one before a change; allowed: another --out";
  const bool begun = fs::exists(journal_folder(out)) && !fs::is_empty(journal_folder(out));
  if (begun && !resume)
    return "has results already; allowed: --resume, which keeps them, or another --out";
  return {};
}

}  // namespace

std::optional<CampaignConfig> read_campaign(const std::string& file, std::FILE* errors) {
  auto campaign = load_campaign(file);
  if (campaign) return std::move(*campaign);
  for (const auto& problem : campaign.error())
    fmt::print(errors, "{}\n", rig_config::to_string(problem));
  return std::nullopt;
}

std::optional<OpenCampaign> find_campaign(const CampaignOptions& options, std::FILE* errors) {
  auto config = read_campaign(options.file, errors);
  if (!config) return std::nullopt;
  fs::path out = folder_of(options);
  if (!fs::exists(campaign_copy(out)))
    fmt::print(errors, "campaign: {} has no campaign; allowed: --out with a folder of results\n",
               out.string());
  else if (holds_another(*config, out))
    fmt::print(errors,
               "campaign: {} holds another campaign, or this one before a change; allowed: its own "
               "file, {}\n",
               out.string(), campaign_copy(out).string());
  else
    return OpenCampaign{std::move(*config), std::move(out)};
  return std::nullopt;
}

std::optional<OpenCampaign> open_campaign(const CampaignOptions& options, std::FILE* errors) {
  auto config = read_campaign(options.file, errors);
  if (!config) return std::nullopt;
  const fs::path out = folder_of(options);
  if (const auto wrong = objection(*config, out, options.resume)) {
    fmt::print(errors, "campaign: {} {}\n", out.string(), *wrong);
    return std::nullopt;
  }
  report::write_file(campaign_copy(out), config->text);
  return OpenCampaign{std::move(*config), out};
}

}  // namespace drydock::campaign
