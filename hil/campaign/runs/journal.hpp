#pragma once

#include <filesystem>
#include <mutex>
#include <string>

#include "hil/campaign/runs/record.hpp"

namespace drydock::campaign {

/// The file in which one process writes down each run as it ends. No other process writes into it,
/// so it needs no lock of a shared file system. A line stands on the disk before add() returns.
class Journal {
 public:
  /// A new file in `folder`, whose name has host, process and `label`. Throws std::runtime_error.
  Journal(const std::filesystem::path& folder, const std::string& label);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// From any thread. Throws std::runtime_error with one line if the disk does not take the line;
  /// what was written of it is taken back.
  void add(const Record& record);

  const std::filesystem::path& path() const { return path_; }

 private:
  std::mutex mutex_;
  std::filesystem::path path_;
  int file_ = -1;
  long length_ = 0;  ///< bytes of whole lines
};

}  // namespace drydock::campaign
