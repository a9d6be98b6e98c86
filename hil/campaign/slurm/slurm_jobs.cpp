#include "hil/campaign/slurm/slurm_jobs.hpp"

#include <fmt/format.h>

#include <regex>
#include <sstream>
#include <stdexcept>

#include "hil/campaign/slurm/command_output.hpp"

namespace drydock::campaign {
namespace {

/// Throws with the last line that the program said.
[[noreturn]] void refuse_slurm(const std::string& program, const CommandOutput& said) {
  constexpr int not_found = 127;
  if (said.code == not_found)
    throw std::runtime_error(program + " cannot be started: Slurm is not installed here");
  throw std::runtime_error(
      fmt::format("{}: {}", program, said.errors.substr(0, said.errors.find('\n'))));
}

std::string asked_slurm(const std::vector<std::string>& words) {
  auto said = output_of(words);
  if (said.code != 0) refuse_slurm(words.front(), said);
  return std::move(said.output);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (!line.empty()) lines.push_back(line);
  return lines;
}

}  // namespace

std::string submit(const JobArray& array) {
  std::vector<std::string> words{"sbatch",
                                 "--parsable",
                                 "--requeue",
                                 "--job-name=drydock-campaign",
                                 fmt::format("--array=0-{}", array.count - 1),
                                 fmt::format("--cpus-per-task={}", array.cpus),
                                 "--chdir=" + std::filesystem::current_path().string(),
                                 "--open-mode=append",
                                 "--output=" + (array.log_folder / "%A_%a.log").string()};
  words.insert(words.end(), array.more.begin(), array.more.end());
  words.push_back(
      fmt::format("--wrap=shard=$(({} + SLURM_ARRAY_TASK_ID)); {}", array.first, array.command));
  const std::string said = asked_slurm(words);
  return said.substr(0, said.find_first_of(";\n"));
}

std::size_t largest_array() {
  const std::string config = asked_slurm({"scontrol", "show", "config"});
  std::smatch found;
  if (!std::regex_search(config, found, std::regex("MaxArraySize *= *([0-9]+)")))
    throw std::runtime_error("scontrol: there is no MaxArraySize");
  return std::stoul(found[1]) - 1;  // it is one more than the largest number of a task
}

std::vector<std::string> task_states(const std::vector<std::string>& jobs) {
  const auto said = output_of({"squeue", "--noheader", "--array", "--format=%T",
                               fmt::format("--jobs={}", fmt::join(jobs, ","))});
  if (said.errors.find("Invalid job id") != std::string::npos) return {};  // long ended
  if (said.code != 0) refuse_slurm("squeue", said);
  return lines_of(said.output);
}

void cancel(const std::vector<std::string>& jobs) {
  std::vector<std::string> words{"scancel", "--quiet"};
  words.insert(words.end(), jobs.begin(), jobs.end());
  asked_slurm(words);
}

}  // namespace drydock::campaign
