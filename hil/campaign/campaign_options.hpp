#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace drydock::campaign {

/// What the command line asks for.
struct CampaignOptions {
  std::string file;
  std::string out;      ///< folder of the results; empty: folder_of() chooses
  std::string earlier;  ///< folder of another campaign to compare with; empty: none
  unsigned jobs = 0;    ///< runs at a time in a process; 0: one a processor, in a task one
  bool resume = false;
  std::optional<std::size_t> only;  ///< this run alone

  bool slurm = false;          ///< tasks of Slurm in place of this machine
  std::size_t shard_runs = 0;  ///< runs of a task; 0: such that there are 1000 tasks at most
  std::string sbatch;          ///< further options of sbatch, between blanks
  bool detach = false;         ///< do not wait for the tasks

  std::string shards;     ///< in a task: the list of the shards; empty elsewhere
  std::size_t shard = 0;  ///< and which of them
};

/// The folder of the results.
inline std::filesystem::path folder_of(const CampaignOptions& options) {
  if (!options.out.empty()) return options.out;
  return std::filesystem::path(options.file).stem().string() + ".campaign";
}

}  // namespace drydock::campaign
