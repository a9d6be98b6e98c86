#pragma once

#include <filesystem>

namespace drydock::campaign {

/// A folder in the temporary folder of this machine; the destructor removes it. Throws
/// std::runtime_error if it cannot be made.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace drydock::campaign
