#pragma once

#include <gmock/gmock.h>

#include <string>
#include <string_view>
#include <vector>

#include "rig_config/load.hpp"

/// The loader's problems of rigs that are given as text.
namespace drydock::rig_config::test {

inline constexpr std::string_view rig_table = "[rig]\nname = \"bench\"\n";  // lines 1, 2
inline constexpr std::string_view dvl_table =                               // lines 3 to 7
    "[[device]]\nname = \"dvl\"\nkind = \"dvl\"\nprotocol = \"pd0\"\nlink = \"pty:dvl\"\n";

inline std::vector<std::string> lines_of(const Problems& problems) {
  std::vector<std::string> lines;
  for (const Problem& problem : problems) lines.push_back(to_string(problem));
  return lines;
}

/// The problems of a rig that has the two tables above and `more` from line 8 on.
inline std::vector<std::string> problems_of(std::string_view more,
                                            const LoadOptions& options = {}) {
  const auto rig = load_rig_text(
      std::string(rig_table) + std::string(dvl_table) + std::string(more), "r.toml", options);
  return rig ? std::vector<std::string>{} : lines_of(rig.error());
}

inline std::vector<std::string> problems_of_text(std::string_view text) {
  const auto rig = load_rig_text(text, "r.toml");
  return rig ? std::vector<std::string>{} : lines_of(rig.error());
}

inline constexpr std::string_view imu_table =
    "[[device]]\nname = \"imu\"\nkind = \"imu\"\nprotocol = \"cia404-imu\"\n"
    "link = \"can:auto?listen=1\"\n";  // never started, so it needs no address

}  // namespace drydock::rig_config::test
