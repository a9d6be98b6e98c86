#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// The part of a campaign's folder that belongs to Slurm.
namespace drydock::campaign {

inline std::filesystem::path slurm_folder(const std::filesystem::path& out) {
  return out / "slurm";
}

/// The jobs of all submissions, the oldest first.
std::vector<std::string> submitted_jobs(const std::filesystem::path& out);
/// Throws std::runtime_error if it cannot be written.
void note_job(const std::filesystem::path& out, const std::string& job);

/// A list of shards that does not exist yet: `1.shards`, `2.shards` and so on.
std::filesystem::path next_list(const std::filesystem::path& out);

}  // namespace drydock::campaign
