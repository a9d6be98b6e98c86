#include "rig_config/file_trouble.hpp"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace drydock::rig_config {

std::string file_trouble(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (error) return error.message();
  if (std::filesystem::is_directory(status)) return "is a folder, not a file";
  if (!std::filesystem::is_regular_file(status)) return "";
  errno = 0;
  if (!std::ifstream(path)) return std::strerror(errno);
  return std::filesystem::file_size(path, error) == 0 && !error ? "is empty" : "";
}

}  // namespace drydock::rig_config
