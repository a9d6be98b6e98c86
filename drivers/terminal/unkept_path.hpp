#pragma once

#include <filesystem>

namespace drydock::terminal {

/// A file or folder that a command is about to make. The destructor removes it, so that a command
/// that failed leaves none behind; not after keep(), and not what stood there before.
class UnkeptPath {
 public:
  explicit UnkeptPath(std::filesystem::path path);
  ~UnkeptPath();
  UnkeptPath(const UnkeptPath&) = delete;
  UnkeptPath& operator=(const UnkeptPath&) = delete;

  void keep() { kept_ = true; }

 private:
  std::filesystem::path path_;
  bool kept_;
};

}  // namespace drydock::terminal
