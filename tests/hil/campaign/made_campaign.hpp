#pragma once

#include <sqlite3.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/hil/program/program.hpp"

/// Campaigns whose runs are a shell script, so that they take no time, and what they leave.
namespace made_campaign {

/// A campaign of `runs` runs of a shell line.
inline std::string campaign_text(const std::string& shell, int runs) {
  return "[campaign]\nname = \"test\"\nrepetitions = " + std::to_string(runs) +
         "\ncommand = \"sh {file:run.sh}\"\n[[file]]\nname = \"run.sh\"\ntext = '''" + shell +
         "'''\n[[parameter]]\nname = \"x\"\nuniform = [0.0, 1.0]\n[[figure]]\nname = \"y\"\nat = "
         "\"/y\"\n";
}

inline void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

/// Values of the first column of a query.
inline std::vector<std::string> column(const std::filesystem::path& store, const std::string& sql) {
  sqlite3* handle = nullptr;
  std::vector<std::string> values;
  sqlite3_open(store.c_str(), &handle);
  sqlite3_exec(
      handle, sql.c_str(),
      [](void* into, int, char** cells, char**) {
        static_cast<std::vector<std::string>*>(into)->emplace_back(cells[0] ? cells[0] : "NULL");
        return 0;
      },
      &values, nullptr);
  sqlite3_close(handle);
  return values;
}

inline std::size_t lines_in(const std::filesystem::path& file) {
  const auto text = program::read_file(file);
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

/// The command that runs the folder's c.toml into its `out`.
inline std::string campaign_in(const program::Folder& folder) {
  return "campaign " + (folder / "c.toml").string() + " --out " + (folder / "out").string();
}

}  // namespace made_campaign
