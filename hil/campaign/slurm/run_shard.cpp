#include "hil/campaign/slurm/run_shard.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/terminal/exit_codes.hpp"
#include "hil/campaign/campaign_folder.hpp"
#include "hil/campaign/report/results.hpp"
#include "hil/campaign/runs/local_engine.hpp"
#include "hil/campaign/slurm/shard_list.hpp"
#include "hil/study/run/study_progress.hpp"

namespace drydock::campaign {

int run_shard(const CampaignOptions& options, std::FILE* errors) {
  const auto config = read_campaign(options.file, errors);
  if (!config) return terminal::exit_usage;
  const std::filesystem::path list(options.shards);
  const auto journals = journal_folder(folder_of(options));
  const auto label = fmt::format("shard-{}-{}", list.stem().string(), options.shard);
  const auto known =
      read_ledger(journals, Plan(*config).runs(), config->figures.size(), label + "-");
  auto runs = read_shard(list, options.shard);
  std::erase_if(runs, [&](std::size_t index) {
    const auto found = known.records.find(index);
    return found != known.records.end() && found->second.failure.empty();
  });
  Journal journal(journals, label);
  study::StudyProgress progress(errors);
  const auto done = run_here(*config, runs, std::max(1U, options.jobs), journal, progress);
  return terminal::exit_of(done == runs.size());
}

}  // namespace drydock::campaign
