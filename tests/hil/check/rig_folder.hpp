#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

/// A temporary copy of the folder rig_config, in which tests write files of their own.
namespace drydock::check {

namespace fs = std::filesystem;

class RigFolder {
 public:
  RigFolder() {
    std::string name = "/tmp/drydock_check_XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) std::abort();
    root_ = name;
    fs::create_directories(root_ / "rig_config/rigs");
    fs::create_directories(root_ / "rig_config/missions");
    const fs::path source = DRYDOCK_SOURCE_DIR;
    for (const char* folder : {"rig_config/sensors", "rig_config/vehicles", "fixtures"})
      fs::create_directory_symlink(source / folder, root_ / folder);
    for (const char* folder : {"rig_config/rigs", "rig_config/missions"})
      for (const auto& file : fs::directory_iterator(source / folder))
        if (file.is_regular_file())
          fs::create_symlink(file.path(), root_ / folder / file.path().filename());
  }
  ~RigFolder() { fs::remove_all(root_); }
  RigFolder(const RigFolder&) = delete;
  RigFolder& operator=(const RigFolder&) = delete;

  /// Writes a file, such as "rigs/mine.toml", and returns its path.
  std::string write(const std::string& name, const std::string& text) const {
    const fs::path path = root_ / "rig_config" / name;
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }

  /// The text of a shipped file.
  static std::string shipped(const std::string& name) {
    std::ifstream in(DRYDOCK_SOURCE_DIR "/rig_config/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  fs::path root_;
};

}  // namespace drydock::check
