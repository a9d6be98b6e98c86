#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// What we ask of Slurm, through its own commands.
namespace drydock::campaign {

/// One job array: a task for each of `count` shards from `first` on.
struct JobArray {
  std::size_t first = 0, count = 0;
  unsigned cpus = 1;                 ///< of a task
  std::string command;               ///< shell line; $shard is the shard's number
  std::filesystem::path log_folder;  ///< a file for what each task prints
  std::vector<std::string> more;     ///< further options of sbatch
};

/// The number of the job. A task whose node fails is queued again. Throws std::runtime_error with
/// what sbatch says.
std::string submit(const JobArray& array);

/// How many tasks one array may have. Throws std::runtime_error if there is no Slurm.
std::size_t largest_array();

/// The states of the tasks that have not ended, a line for each. Throws std::runtime_error if Slurm
/// does not answer.
std::vector<std::string> task_states(const std::vector<std::string>& jobs);

/// Tasks that have ended already are no error.
void cancel(const std::vector<std::string>& jobs);

}  // namespace drydock::campaign
