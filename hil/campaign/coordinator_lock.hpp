#pragma once

#include <filesystem>

namespace drydock::campaign {

/// While it lives, no other process gives out runs of the campaign in this folder. The kernel ends
/// it with the process, however that ends. On a file system without locks it keeps nobody out.
class CoordinatorLock {
 public:
  /// Throws std::runtime_error with one line if another process has it.
  explicit CoordinatorLock(const std::filesystem::path& folder);
  ~CoordinatorLock();
  CoordinatorLock(const CoordinatorLock&) = delete;
  CoordinatorLock& operator=(const CoordinatorLock&) = delete;

 private:
  int file_;
};

}  // namespace drydock::campaign
