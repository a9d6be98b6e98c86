#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace drydock::campaign {

/// What the command line asks for.
struct CampaignOptions {
  std::string file;
  std::string out;      ///< folder of the results; empty: default_out()
  std::string earlier;  ///< folder of another campaign to compare with; empty: none
  unsigned jobs = 0;    ///< runs at a time in one process; 0: one a processor; in a task of Slurm 1
  bool resume = false;
  std::optional<std::size_t> only;  ///< this run alone
};

inline std::filesystem::path default_out(const std::string& file) {
  return std::filesystem::path(file).stem().string() + ".campaign";
}

}  // namespace drydock::campaign
