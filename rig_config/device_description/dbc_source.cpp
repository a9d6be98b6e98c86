#include "rig_config/device_description/dbc_source.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "drivers/wire/dbc/reader.hpp"
#include "rig_config/checks/checks.hpp"
#include "rig_config/file_trouble.hpp"
#include "rig_config/rules/explain.hpp"

namespace drydock::rig_config {
namespace {

std::optional<wire::dbc::Database> database_of(std::string_view text, const std::string& path,
                                               Problems& problems) {
  wire::dbc::Reading reading = wire::dbc::read(text);
  for (const wire::dbc::Remark& error : reading.errors)
    problems.push_back({path, static_cast<int>(error.at.line), static_cast<int>(error.at.column),
                        "/", error.text});
  if (!reading.errors.empty()) return {};
  return std::move(reading.database);
}

/// The text of a file; empty after the reason why there is none was put in `trouble`.
std::optional<std::string> read_dbc(const std::string& path, std::string& trouble) {
  if (const auto why = file_trouble(path); !why.empty()) {
    trouble = fmt::format("{}: cannot be read: {}", path, why);
    return {};
  }
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error || size > wire::dbc::longest_text) {
    trouble = fmt::format("{} has {} bytes, allowed: up to {} (16 MiB)", path, size,
                          wire::dbc::longest_text);
    return {};
  }
  std::string text(size, '\0');
  std::ifstream in(path, std::ios::binary);
  if (!in.read(text.data(), static_cast<std::streamsize>(size))) {
    trouble = path + ": cannot be read to its end";
    return {};
  }
  return text;
}

}  // namespace

std::optional<wire::dbc::Database> find_dbc(const Node& word, const std::string& file,
                                            std::string& read_from, Problems& problems) {
  const std::string path = beside(file, word.text);
  std::error_code error;
  if (std::filesystem::exists(path, error)) {
    read_from = path;
    std::string trouble;
    const auto text = read_dbc(path, trouble);
    if (text) return database_of(*text, path, problems);
    problems.push_back({file, word.at.line, word.at.column, "/protocol/dbc", std::move(trouble)});
    return {};
  }
  std::vector<std::string> names;
  for (const auto& [name, text] : built_in_dbcs()) {
    if (name == word.text) return database_of(text, "rig_config/dbc/" + word.text, problems);
    names.emplace_back(name);
  }
  problems.push_back({file, word.at.line, word.at.column, "/protocol/dbc",
                      fmt::format("there is no file {}, and the program contains no \"{}\"{}, "
                                  "allowed: a file beside the description, {}",
                                  path, word.text, did_you_mean(word.text, names), listed(names))});
  return {};
}

}  // namespace drydock::rig_config
