#pragma once

#include <filesystem>
#include <string>

namespace drydock::report {

/// Writes a whole file, its folders too where they are missing. Throws std::runtime_error with one
/// line.
void write_file(const std::filesystem::path& path, const std::string& text);

}  // namespace drydock::report
