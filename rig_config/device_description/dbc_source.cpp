#include "rig_config/device_description/dbc_source.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "drivers/wire/dbc/reader.hpp"
#include "rig_config/checks/checks.hpp"
#include "rig_config/rules/explain.hpp"
#include "rig_config/toml/checked_file.hpp"

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

}  // namespace

std::optional<wire::dbc::Database> find_dbc(const Node& word, const std::string& file,
                                            std::string& read_from, Problems& problems) {
  const std::string path = beside(file, word.text);
  std::error_code error;
  if (std::filesystem::exists(path, error)) {
    read_from = path;
    const auto text = read_file(path);
    if (text) return database_of(*text, path, problems);
    append(problems, text.error());
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
