#include "hil/campaign/finish_campaign.hpp"

#include <fmt/format.h>

#include "drivers/terminal/exit_codes.hpp"
#include "hil/campaign/report/result_store.hpp"
#include "hil/campaign/report/summary.hpp"
#include "hil/report/write_file.hpp"

namespace drydock::campaign {
namespace {

/// What a reader of the figures has to know about the journals.
void say_what_is_odd(const Ledger& ledger, std::FILE* errors) {
  if (ledger.damaged_lines > 0)
    fmt::print(errors, "campaign: {} damaged lines in the journals; their runs count as missing\n",
               ledger.damaged_lines);
  if (!ledger.differing.empty())
    fmt::print(errors,
               "campaign: {} runs were done twice with other figures, the first is run {}: its "
               "command does not repeat itself\n",
               ledger.differing.size(), ledger.differing.front());
}

int verdict(const Ledger& ledger, std::size_t runs, const Results& results, std::FILE* errors) {
  const std::size_t missing = runs - ledger.records.size();
  const auto lacking = lacking_figures(results);
  for (const auto& l : lacking)
    fmt::print(
        errors, "campaign: figure '{}': {} of {} runs have no number at {}, the first is run {}\n",
        l.figure->name, l.runs, results.records.size() - results.failed(), l.figure->at, l.first);
  if (missing == 0 && results.failed() == 0) return terminal::exit_of(lacking.empty());
  fmt::print(errors, "campaign: {} of {} runs failed, {} are missing; --resume runs these again\n",
             results.failed(), runs, missing);
  return terminal::exit_failed;
}

}  // namespace

int finish_campaign(const OpenCampaign& campaign, const CampaignOptions& options, std::FILE* out,
                    std::FILE* errors) {
  const std::size_t runs = Plan(campaign.config).runs();
  const Ledger ledger =
      read_ledger(journal_folder(campaign.out), runs, campaign.config.figures.size());
  const Results results = in_order(campaign.config, ledger);
  Summary summary{
      .results = &results, .path = options.file, .figures = analysis_of(results), .shifts = {}};
  if (!options.earlier.empty())
    summary.shifts = shifts_since(read_results(options.earlier), results);
  if (!options.earlier.empty() && summary.shifts.empty())
    fmt::print(errors, "campaign: --compare: no figure of {} is one of this campaign\n",
               options.earlier);
  write_store(campaign.out / "results.sqlite", results);
  report::write_file(campaign.out / "summary.json", to_json_text(summary));
  report::write_file(campaign.out / "index.html", to_page(summary));
  for (const auto& table : tables_of(summary)) fmt::print(out, "{}\n", report::to_text(table));
  say_what_is_odd(ledger, errors);
  return verdict(ledger, runs, results, errors);
}

}  // namespace drydock::campaign
