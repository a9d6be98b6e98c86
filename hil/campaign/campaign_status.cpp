#include "hil/campaign/campaign_status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <stdexcept>

#include "drivers/terminal/exit_codes.hpp"
#include "drivers/terminal/progress_bar.hpp"
#include "hil/campaign/campaign_folder.hpp"
#include "hil/campaign/report/results.hpp"
#include "hil/campaign/slurm/slurm_folder.hpp"
#include "hil/campaign/slurm/slurm_jobs.hpp"

namespace drydock::campaign {
namespace {

constexpr double ms_per_s = 1000;

std::vector<std::int64_t> last_ends(const Ledger& ledger) {
  constexpr std::size_t looked_at = 1000;
  std::vector<std::int64_t> ends;
  for (const auto& [index, record] : ledger.records) ends.push_back(record.ended_ms);
  std::ranges::sort(ends);
  if (ends.size() > looked_at) ends.erase(ends.begin(), ends.end() - looked_at);
  return ends;
}

/// Runs a second; 0: not known.
double rate_of(const std::vector<std::int64_t>& ends) {
  if (ends.size() < 2 || ends.back() == ends.front()) return 0;
  return ms_per_s * static_cast<double>(ends.size() - 1) /
         static_cast<double>(ends.back() - ends.front());
}

/// How many tasks of Slurm are in which state, if there are any.
void print_tasks(const std::vector<std::string>& jobs, std::FILE* out, std::FILE* errors) {
  if (jobs.empty()) return;
  try {
    std::map<std::string, std::size_t> counts;
    for (const auto& state : task_states(jobs)) ++counts[state];
    for (const auto& [state, count] : counts) fmt::print(out, "Slurm: {} tasks {}\n", count, state);
    if (counts.empty()) fmt::print(out, "Slurm: all tasks have ended\n");
  } catch (const std::runtime_error& error) {
    fmt::print(errors, "campaign: {}\n", error.what());
  }
}

}  // namespace

std::string progress_text(const Ledger& ledger, std::size_t runs, std::int64_t now_ms) {
  const std::size_t left = runs - ledger.records.size();
  const auto failed = std::ranges::count_if(
      ledger.records, [](const auto& entry) { return !entry.second.failure.empty(); });
  std::string text = fmt::format("{} of {} runs, {} failed{}", ledger.records.size(), runs, failed,
                                 left == 0 && failed > 0 ? "; --resume runs these again" : "");
  const auto ends = last_ends(ledger);
  if (left == 0 || ends.empty()) return text;
  if (const double rate = rate_of(ends); rate > 0)
    text += fmt::format(", {:.3g} runs/s, {:.0f} s left", rate, static_cast<double>(left) / rate);
  return text + fmt::format(", the last one ended {:.0f} s ago",
                            static_cast<double>(now_ms - ends.back()) / ms_per_s);
}

int print_status(const CampaignOptions& options, std::FILE* out, std::FILE* errors) {
  const auto campaign = find_campaign(options, errors);
  if (!campaign) return terminal::exit_usage;
  const auto& [config, folder] = *campaign;
  const std::size_t runs = Plan(config).runs();
  const Ledger ledger = read_ledger(journal_folder(folder), runs, config.figures.size());
  const auto now = std::chrono::duration_cast<std::chrono::milliseconds>(
      std::chrono::system_clock::now().time_since_epoch());
  const double done = static_cast<double>(ledger.records.size()) / static_cast<double>(runs);
  fmt::print(out, "{} {} {}\n", config.name, terminal::progress_bar(done),
             progress_text(ledger, runs, now.count()));
  print_tasks(submitted_jobs(folder), out, errors);
  return terminal::exit_success;
}

}  // namespace drydock::campaign
