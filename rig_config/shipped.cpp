#include "rig_config/shipped.hpp"

#include <dlfcn.h>

#include <algorithm>

namespace drydock::rig_config {

namespace {

bool holds_files(const std::filesystem::path& folder) {
  std::error_code error;
  return std::filesystem::is_directory(folder / "rig_config" / rigs, error);
}

/// In a folder above `file`, or in share/drydock beside one.
std::filesystem::path folder_above(const std::filesystem::path& file) {
  for (auto folder = file.parent_path(); folder != folder.parent_path();
       folder = folder.parent_path())
    for (const auto& place : {folder, folder / "share/drydock"})
      if (holds_files(place)) return place;
  return {};
}

/// The file that this code is in: the program, or a library or a module of another one.
std::filesystem::path own_file() {
  std::error_code error;
  Dl_info found{};
  const bool known = dladdr(reinterpret_cast<const void*>(&own_file), &found) != 0;
  return known ? std::filesystem::canonical(found.dli_fname, error) : std::filesystem::path{};
}

std::filesystem::path find_folder() {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto found = folder_above(program);
  return found.empty() ? folder_above(own_file()) : found;
}

/// A folder of the name (of results) hides no file.
bool is_there(const std::filesystem::path& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  return std::filesystem::exists(status) && !std::filesystem::is_directory(status);
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
  if (word.empty() || is_there(word)) return word;
  if (is_there(word + ".toml")) return word + ".toml";
  if (shipped_folder().empty()) return word;
  const auto folder = shipped_folder() / "rig_config" / kind;
  for (const auto& path : {folder / (word + ".toml"), folder / word, shipped_folder() / word})
    if (is_there(path)) return path.string();
  return word;
}

}  // namespace drydock::rig_config
