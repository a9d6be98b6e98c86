#pragma once

#include <cstddef>
#include <filesystem>
#include <map>

namespace drydock::campaign {

/// Counts the lines of all journals of a folder, and reads only what is new since the last time.
class LineCounter {
 public:
  explicit LineCounter(std::filesystem::path folder) : folder_(std::move(folder)) {}
  std::size_t count();

 private:
  std::filesystem::path folder_;
  std::map<std::filesystem::path, std::uintmax_t> read_;  ///< bytes by file
  std::size_t lines_ = 0;
};

}  // namespace drydock::campaign
