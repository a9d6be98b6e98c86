#pragma once

#include <algorithm>
#include <filesystem>

#include "hil/program/capture_arguments.hpp"
#include "hil/replay/rigs/rig_captures.hpp"

namespace drydock::program {

/// NAME=FILE, where there is no file of the whole name.
inline replay::RigCaptures::File named_file(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || rig_config::file_trouble(text).empty()) return {text};
  return {text.substr(equals + 1), text.substr(0, equals)};
}

/// As named_file(), and the files of a folder in the order of their names. A folder without files
/// stays what is named, and who opens it says that it is a folder.
inline std::vector<replay::RigCaptures::File> named_files(const std::string& text) {
  namespace fs = std::filesystem;
  auto file = named_file(text);
  if (!fs::is_directory(file.path)) return {file};
  std::vector<replay::RigCaptures::File> files;
  for (const auto& entry : fs::directory_iterator(file.path))
    if (entry.is_regular_file() && !entry.path().filename().string().starts_with('.'))
      files.push_back({entry.path().string(), file.device, file.path});
  std::ranges::sort(files, {}, &replay::RigCaptures::File::path);
  return files.empty() ? std::vector{file} : files;
}

/// Throws std::runtime_error where it is none.
inline void must_be_capture(const replay::RigCaptures::File& file) {
  std::error_code unknown;  // a folder may have files in which nothing came yet
  if (!file.folder.empty() && std::filesystem::file_size(file.path, unknown) == 0) return;
  must_be_readable(file.path);
  if (replay::is_recording(file.path))
    throw std::runtime_error(file.path + ": a recording is played alone, and names its devices");
}

}  // namespace drydock::program
