#include "hil/campaign/slurm/slurm_folder.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

namespace drydock::campaign {
namespace {

std::filesystem::path jobs_file(const std::filesystem::path& out) {
  return slurm_folder(out) / "jobs";
}

}  // namespace

std::vector<std::string> submitted_jobs(const std::filesystem::path& out) {
  std::vector<std::string> jobs;
  std::ifstream file(jobs_file(out));
  for (std::string line; std::getline(file, line);) jobs.push_back(line);
  return jobs;
}

void note_job(const std::filesystem::path& out, const std::string& job) {
  std::ofstream file(jobs_file(out), std::ios::app);
  file << job << "\n";
  if (!file.flush())
    throw std::runtime_error(fmt::format("{}: cannot be written", jobs_file(out).string()));
}

std::filesystem::path next_list(const std::filesystem::path& out) {
  std::size_t number = 1;
  while (std::filesystem::exists(slurm_folder(out) / fmt::format("{}.shards", number))) ++number;
  return slurm_folder(out) / fmt::format("{}.shards", number);
}

}  // namespace drydock::campaign
