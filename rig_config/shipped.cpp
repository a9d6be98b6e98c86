#include "rig_config/shipped.hpp"

#include <algorithm>

namespace drydock::rig_config {

namespace {

bool holds_files(const std::filesystem::path& folder) {
  std::error_code error;
  return std::filesystem::is_directory(folder / "rig_config" / rigs, error);
}

std::filesystem::path find_folder() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  for (auto folder = program.parent_path(); folder != folder.parent_path();
       folder = folder.parent_path())
    if (holds_files(folder)) return folder;
  const auto installed = program.parent_path().parent_path() / "share/drydock";
  return holds_files(installed) ? installed : std::filesystem::path{};
}

bool is_there(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::exists(path, error);
}

}  // namespace

std::filesystem::path shipped_folder() {
  static const auto folder = find_folder();
  return folder;
}

std::vector<std::filesystem::path> shipped_files(std::string_view kind) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry :
       std::filesystem::directory_iterator(shipped_folder() / "rig_config" / kind, error))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::ranges::sort(files, {}, [](const auto& file) { return file.stem(); });
  return files;
}

std::string find_shipped(const std::string& word, std::string_view kind) {
  if (word.empty() || is_there(word) || shipped_folder().empty()) return word;
  const auto folder = shipped_folder() / "rig_config" / kind;
  for (const auto& path : {folder / (word + ".toml"), folder / word, shipped_folder() / word})
    if (is_there(path)) return path.string();
  return word;
}

}  // namespace drydock::rig_config
