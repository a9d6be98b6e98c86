#include "drivers/terminal/unkept_path.hpp"

#include <utility>

namespace drydock::terminal {

UnkeptPath::UnkeptPath(std::filesystem::path path) : path_(std::move(path)) {
  std::error_code missing;
  kept_ = std::filesystem::exists(std::filesystem::symlink_status(path_, missing));
}

UnkeptPath::~UnkeptPath() {
  std::error_code ignored;
  if (!kept_) std::filesystem::remove_all(path_, ignored);
}

}  // namespace drydock::terminal
