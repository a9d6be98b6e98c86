#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hil/campaign/plan/parameter.hpp"
#include "rig_config/load.hpp"

/// A campaign: one command line run many times with other values, and the figures of each run.
namespace drydock::campaign {

enum class Better : std::uint8_t { less, more, near_zero };

/// A number that each run gives.
struct FigureConfig {
  std::string name;
  std::string at;  ///< path in the run's JSON; figure_at() reads it
  Better better = Better::less;
  double same_within = 0;  ///< a difference of medians up to this is none
};

/// A file that each run gets, with that run's values in place of the placeholders.
struct FileConfig {
  std::string name, text;
};

struct CampaignConfig {
  std::string name{}, command{};
  std::uint64_t seed = 1;
  std::size_t repetitions = 1;  ///< of each combination of lists and grids
  double timeout_s = 0;         ///< 0: none
  double confidence = 0.95;     ///< of every bound in the report
  std::vector<ParameterConfig> parameters{};
  std::vector<FigureConfig> figures{};
  std::vector<FileConfig> files{};
  std::string text{};  ///< of the whole file
};

/// The campaign of a file, or every problem of it.
rig_config::Loaded<CampaignConfig> load_campaign(const std::string& path);
rig_config::Loaded<CampaignConfig> load_campaign_text(std::string_view text,
                                                      const std::string& path);

/// The JSON Schema (draft-07) of campaign files.
std::string_view campaign_schema_text();

}  // namespace drydock::campaign
