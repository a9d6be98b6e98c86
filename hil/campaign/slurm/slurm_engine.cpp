#include "hil/campaign/slurm/slurm_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "drivers/terminal/exit_codes.hpp"
#include "hil/campaign/report/repeat.hpp"
#include "hil/campaign/report/results.hpp"
#include "hil/campaign/slurm/line_counter.hpp"
#include "hil/campaign/slurm/shard_list.hpp"
#include "hil/campaign/slurm/slurm_folder.hpp"
#include "hil/campaign/slurm/slurm_jobs.hpp"
#include "hil/study/run/study_progress.hpp"

namespace drydock::campaign {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> blank_separated(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

/// A shard that takes long is lost as a whole in no case: its journal has what it did. So its size
/// is a matter of overhead alone.
std::size_t shard_size(const CampaignOptions& options, std::size_t missing) {
  constexpr std::size_t usual_shards = 1000;
  return options.shard_runs > 0 ? options.shard_runs : (missing + usual_shards - 1) / usual_shards;
}

std::string task_command(const OpenCampaign& campaign, const fs::path& list, unsigned jobs) {
  const fs::path out = fs::absolute(campaign.out);
  return fmt::format("exec {} campaign {} --out {} --jobs {} --shards {} --shard $shard",
                     shell_word(fs::read_symlink("/proc/self/exe").string()),
                     shell_word(campaign_copy(out).string()), shell_word(out.string()), jobs,
                     shell_word(fs::absolute(list).string()));
}

/// A list that no job reads.
void take_back(const fs::path& list) {
  std::error_code ignored;
  fs::remove(list, ignored);
  fs::remove(list.parent_path(), ignored);  // where it is empty
}

/// The jobs of this submission.
std::vector<std::string> submitted(const OpenCampaign& campaign, const CampaignOptions& options,
                                   const std::vector<std::size_t>& missing) {
  const std::size_t most = largest_array();
  const fs::path list = next_list(campaign.out);
  const std::size_t shards = write_shards(list, missing, shard_size(options, missing.size()));
  const unsigned cpus = std::max(1U, options.jobs);
  std::vector<std::string> jobs;
  try {
    for (std::size_t first = 0; first < shards; first += most) {
      jobs.push_back(submit({.first = first,
                             .count = std::min(most, shards - first),
                             .cpus = cpus,
                             .command = task_command(campaign, list, cpus),
                             .log_folder = fs::absolute(slurm_folder(campaign.out)),
                             .more = blank_separated(options.sbatch)}));
      note_job(campaign.out, jobs.back());
    }
  } catch (const std::exception&) {
    if (jobs.empty()) take_back(list);
    throw;
  }
  return jobs;
}

/// False: all have ended. While Slurm does not answer, they have not: its controller may be down
/// for a while, and the tasks go on without it.
bool are_alive(const std::vector<std::string>& jobs, std::string& trouble, std::FILE* errors) {
  try {
    const bool alive = !task_states(jobs).empty();
    trouble.clear();
    return alive;
  } catch (const std::runtime_error& error) {
    if (trouble != error.what()) fmt::print(errors, "campaign: {}; waiting\n", error.what());
    trouble = error.what();
    return true;
  }
}

/// Waits for the end of the jobs, or ends them.
void wait_for(const std::vector<std::string>& jobs, const OpenCampaign& campaign,
              std::size_t missing, std::FILE* errors) {
  constexpr auto between_looks = std::chrono::seconds{1};
  LineCounter lines(journal_folder(campaign.out));
  const std::size_t before = lines.count();
  std::size_t done = 0;
  std::string trouble;
  study::StudyProgress progress(errors);
  while (are_alive(jobs, trouble, errors)) {
    if (progress.stopped()) {
      cancel(jobs);
      break;
    }
    std::this_thread::sleep_for(between_looks);
    done = std::min(lines.count() - before, missing);
    if (done > 0) progress.on_run(campaign.config.name, done, missing);
  }
  done = std::min(lines.count() - before, missing);
  const std::size_t runs = Plan(campaign.config).runs();
  progress.finish(campaign.config.name, done, {.runs = runs, .seed = campaign.config.seed},
                  runs - missing);
}

void refuse_second_submission(const OpenCampaign& campaign) {
  const auto jobs = submitted_jobs(campaign.out);
  if (jobs.empty() || task_states(jobs).empty()) return;
  throw std::runtime_error(
      fmt::format("tasks of {} are still in Slurm's queue; allowed: --status, --cancel",
                  campaign.out.string()));
}

}  // namespace

bool run_on_slurm(const OpenCampaign& campaign, const CampaignOptions& options, std::FILE* out,
                  std::FILE* errors) {
  refuse_second_submission(campaign);
  const std::size_t runs = Plan(campaign.config).runs();
  const auto ledger =
      read_ledger(journal_folder(campaign.out), runs, campaign.config.figures.size());
  const auto missing = missing_runs(ledger, runs);
  if (missing.empty()) return true;
  const auto jobs = submitted(campaign, options, missing);
  if (options.detach) {
    fmt::print(out, "submitted {} runs as job {}; --resume merges them when they are done\n",
               missing.size(), fmt::join(jobs, ", "));
    return false;
  }
  wait_for(jobs, campaign, missing.size(), errors);
  return true;
}

int cancel_campaign(const CampaignOptions& options, std::FILE* out, std::FILE* errors) {
  const auto campaign = find_campaign(options, errors);
  if (!campaign) return terminal::exit_usage;
  const auto jobs = submitted_jobs(campaign->out);
  if (jobs.empty()) {
    fmt::print(errors, "campaign: {} has no jobs of Slurm; Ctrl-C ends runs on this machine\n",
               campaign->out.string());
    return terminal::exit_failed;
  }
  cancel(jobs);
  fmt::print(out, "cancelled {} jobs; what they did stays\n", jobs.size());
  return terminal::exit_success;
}

}  // namespace drydock::campaign
