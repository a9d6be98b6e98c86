#include "tests/drivers/described/witnesses_of.hpp"

#include <toml++/toml.h>
#include <algorithm>
#include <vector>

namespace drydock::described::test {
namespace {

toml::table rows_of(const std::string& path) {
  return toml::parse_file(DRYDOCK_SOURCE_DIR "/tests/witnesses/" + path + ".toml");
}

std::vector<std::string> texts_of(const toml::table& row, std::string_view key) {
  std::vector<std::string> texts;
  for (const auto& one : *row[key].as_array()) texts.push_back(one.value<std::string>().value());
  return texts;
}

std::string joined(const std::vector<std::string>& names) {
  std::string cell;
  for (const auto& name : names) cell += (cell.empty() ? "`" : " `") + name + "`";
  return cell;
}

/// Of claims about no more than `most` protocols.
std::string witnesses_of(const std::string& kind, const std::string& about, std::size_t most) {
  const auto claims = rows_of("claims/" + kind);
  const auto captures = rows_of("witnesses/captures"), programs = rows_of("witnesses/programs");
  std::vector<std::string> others, packed;
  for (const auto& one : *claims["claim"].as_array()) {
    const auto names = texts_of(*one.as_table(), kind);
    if (names.size() > most || std::ranges::find(names, about) == names.end()) continue;
    for (const auto& by : texts_of(*one.as_table(), "by")) {
      auto& list = captures.contains(by) || programs.contains(by) ? others : packed;
      if (std::ranges::find(list, by) == list.end()) list.push_back(by);
    }
  }
  return joined(others.empty() ? packed : others);
}

}  // namespace

std::string witness_cell(const std::string& kind, const std::string& about) {
  const auto close = witnesses_of(kind, about, 2);
  return close.empty() ? witnesses_of(kind, about, 4) : close;
}

}  // namespace drydock::described::test
