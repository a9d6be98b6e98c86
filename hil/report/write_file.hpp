#pragma once

#include <filesystem>
#include <string>

namespace drydock::report {

/// Writes a whole file and makes missing folders. Throws std::runtime_error with one line; then no
/// part of the file is left.
void write_file(const std::filesystem::path& path, const std::string& text);

}  // namespace drydock::report
