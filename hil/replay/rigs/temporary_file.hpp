#pragma once

#include <string>

namespace drydock::replay {

/// A new file in the folder for temporary ones, which lives as long as this.
class TemporaryFile {
 public:
  /// Throws std::runtime_error with one line.
  TemporaryFile();
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace drydock::replay
