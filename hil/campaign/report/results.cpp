#include "hil/campaign/report/results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace drydock::campaign {

std::size_t Results::failed() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(records, [](const Record& r) { return !r.failure.empty(); }));
}

Results in_order(const CampaignConfig& campaign, const Ledger& ledger) {
  Results results{.campaign = campaign, .records = {}};
  for (const auto& [index, record] : ledger.records) results.records.push_back(record);
  return results;
}

Results read_results(const std::filesystem::path& out) {
  const auto campaign = load_campaign(campaign_copy(out).string());
  if (!campaign)
    throw std::runtime_error(fmt::format("{} has no campaign: {}", out.string(),
                                         rig_config::to_string(campaign.error().front())));
  return in_order(*campaign, read_ledger(journal_folder(out), Plan(*campaign).runs(),
                                         campaign->figures.size()));
}

Column column_of(const Results& results, std::size_t figure) {
  Column column;
  for (const auto& record : results.records)
    if (record.failure.empty() && record.figures[figure]) {
      column.indexes.push_back(record.index);
      column.values.push_back(*record.figures[figure]);
    }
  return column;
}

std::vector<LackingFigure> lacking_figures(const Results& results) {
  std::vector<LackingFigure> all;
  for (std::size_t i = 0; i < results.campaign.figures.size(); ++i) {
    LackingFigure lacking{.figure = &results.campaign.figures[i]};
    for (const auto& record : results.records) {
      if (!record.failure.empty() || record.figures[i]) continue;
      if (lacking.runs++ == 0) lacking.first = record.index;
    }
    if (lacking.runs > 0) all.push_back(lacking);
  }
  return all;
}

}  // namespace drydock::campaign
