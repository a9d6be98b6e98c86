#pragma once

#include <filesystem>
#include <vector>

#include "hil/campaign/plan/plan.hpp"
#include "hil/campaign/runs/ledger.hpp"

namespace drydock::campaign {

/// A finished or partly finished campaign: its runs in the order of their indexes.
struct Results {
  CampaignConfig campaign;
  std::vector<Record> records;

  std::size_t failed() const;
};

/// The file and the folder of a campaign, in its folder.
inline std::filesystem::path campaign_copy(const std::filesystem::path& out) {
  return out / "campaign.toml";
}
inline std::filesystem::path journal_folder(const std::filesystem::path& out) {
  return out / "runs";
}

/// What the folder of a campaign has. Throws std::runtime_error with one line if it has none.
Results read_results(const std::filesystem::path& out);

Results in_order(const CampaignConfig& campaign, const Ledger& ledger);

/// One figure over the runs that have it, in their order.
struct Column {
  std::vector<std::size_t> indexes;
  std::vector<double> values;
};
Column column_of(const Results& results, std::size_t figure);

/// A figure that is not in the JSON of every run that did not fail.
struct LackingFigure {
  const FigureConfig* figure = nullptr;  // lives in the results
  std::size_t runs = 0;                  ///< that do not have it
  std::size_t first = 0;                 ///< of them
};
std::vector<LackingFigure> lacking_figures(const Results& results);

}  // namespace drydock::campaign
