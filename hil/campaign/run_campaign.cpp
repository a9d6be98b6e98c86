#include "hil/campaign/run_campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "drivers/terminal/exit_codes.hpp"
#include "hil/campaign/coordinator_lock.hpp"
#include "hil/campaign/finish_campaign.hpp"
#include "hil/campaign/report/repeat.hpp"
#include "hil/campaign/report/results.hpp"
#include "hil/campaign/runs/local_engine.hpp"
#include "hil/campaign/runs/one_run.hpp"
#include "hil/campaign/slurm/run_shard.hpp"
#include "hil/campaign/slurm/slurm_engine.hpp"
#include "hil/campaign/slurm/slurm_folder.hpp"
#include "hil/campaign/slurm/slurm_jobs.hpp"
#include "hil/study/run/study_progress.hpp"

namespace drydock::campaign {
namespace {

namespace fs = std::filesystem;

/// The missing runs on this machine.
void do_missing(const OpenCampaign& campaign, unsigned jobs, std::FILE* errors) {
  const auto folder = journal_folder(campaign.out);
  const std::size_t runs = Plan(campaign.config).runs();
  const auto missing =
      missing_runs(read_ledger(folder, runs, campaign.config.figures.size()), runs);
  if (missing.empty()) return;
  Journal journal(folder, "local");
  study::StudyProgress progress(errors);
  const auto done = run_here(campaign.config, missing, jobs, journal, progress);
  progress.finish(campaign.config.name, done, {.runs = runs, .seed = campaign.config.seed},
                  runs - missing.size());
}

/// One run in a folder that stays, with what it gave.
int run_only(const CampaignConfig& config, const CampaignOptions& options, std::FILE* out,
             std::FILE* errors) {
  const std::size_t index = *options.only;
  if (index >= Plan(config).runs()) {
    fmt::print(errors, "campaign: there is no run {}, allowed: 0 to {}\n", index,
               Plan(config).runs() - 1);
    return terminal::exit_usage;
  }
  const fs::path folder =
      options.out.empty() ? fs::path(fmt::format("run-{}", index)) : fs::path(options.out);
  fs::create_directories(folder);
  const terminal::InterruptFlag interrupt;
  const auto record = do_run(config, index, folder, [&] { return interrupt.set(); });
  if (!record) return terminal::exit_failed;
  for (std::size_t i = 0; i < config.figures.size(); ++i)
    fmt::print(out, "{} {}\n", config.figures[i].name,
               record->figures[i] ? fmt::format("{}", *record->figures[i]) : "-");
  if (record->failure.empty()) return terminal::exit_success;
  fmt::print(errors, "campaign: run {} failed: {}\n", index, record->failure);
  return terminal::exit_failed;
}

}  // namespace

int run_campaign(const CampaignOptions& options, std::FILE* out, std::FILE* errors) {
  if (!options.shards.empty()) return run_shard(options, errors);
  if (options.only) {
    const auto config = read_campaign(options.file, errors);
    return config ? run_only(*config, options, out, errors) : terminal::exit_usage;
  }
  if (!options.earlier.empty()) {  // not after hours of runs
    try {
      read_results(options.earlier);
    } catch (const std::exception& error) {
      fmt::print(errors, "campaign: --compare: {}\n", error.what());
      return terminal::exit_usage;
    }
  }
  if (options.slurm && !options.resume) largest_array();  // without Slurm nothing is begun
  const bool is_new = !fs::exists(folder_of(options));
  const auto campaign = open_campaign(options, errors);
  if (!campaign) return terminal::exit_usage;
  const CoordinatorLock lock(campaign->out);
  if (options.slurm) {
    const bool all_done = [&] {
      try {
        return run_on_slurm(*campaign, options, out, errors);
      } catch (const std::exception&) {
        if (is_new && submitted_jobs(campaign->out).empty()) fs::remove_all(campaign->out);
        throw;
      }
    }();
    return all_done ? finish_campaign(*campaign, options, out, errors) : terminal::exit_success;
  }
  const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
  do_missing(*campaign, options.jobs > 0 ? options.jobs : processors, errors);
  return finish_campaign(*campaign, options, out, errors);
}

}  // namespace drydock::campaign
