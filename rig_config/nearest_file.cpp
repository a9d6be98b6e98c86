#include "rig_config/nearest_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "rig_config/rules/explain.hpp"
#include "rig_config/shipped.hpp"

namespace drydock::rig_config {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_beside(const fs::path& path) {
  std::vector<std::string> names;
  std::error_code error;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
    names.push_back(entry->path().filename().string());
  std::ranges::sort(names);  // a folder has no order of its own
  return names;
}

void add_shipped(std::vector<std::string>& names) {
  for (const auto kind : kinds_of_files)
    for (const auto& file : shipped_files(kind)) names.push_back(file.stem().string());
}

}  // namespace

std::string nearest_file(const std::string& path) {
  const fs::path asked(path);
  std::error_code error;
  if (fs::exists(asked, error)) return "";
  if (fs::exists(path + ".toml", error)) return " (did you mean '" + path + ".toml'?)";
  auto names = names_beside(asked);
  const bool bare_word = !asked.has_parent_path();
  if (bare_word) add_shipped(names);
  auto meant = did_you_mean(asked.filename().string(), names);
  if (meant.empty() && bare_word) meant = did_you_mean(asked.stem().string(), names);
  if (meant.empty() && bare_word && !asked.has_extension())
    return "; `drydock example` lists the files that come with the program";
  return meant;
}

std::string why_no_file(const std::string& path, std::string_view kind) {
  std::error_code error;
  if (fs::is_directory(path, error)) return path + " is a folder, not a file";
  const std::string why = "there is no file " + path;
  const fs::path asked(path);
  if (fs::exists(path + ".toml", error)) return why + nearest_file(path);
  if (auto meant = did_you_mean(asked.filename().string(), names_beside(asked)); !meant.empty())
    return why + meant;
  const std::string name = asked.stem().string();
  std::vector<std::string> shipped;
  for (const auto& one : kind.empty() ? std::vector<fs::path>() : shipped_files(kind))
    shipped.push_back(one.stem().string());
  if (std::ranges::find(shipped, name) == shipped.end()) return why + did_you_mean(name, shipped);
  return fmt::format("{}; `drydock example {}/{} > {}` writes the one that comes with the program",
                     why, kind, name, fs::path(path).replace_extension(".toml").string());
}

}  // namespace drydock::rig_config
