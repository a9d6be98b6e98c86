#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/drivers/wire/byte_streams.hpp"

/// The regression logs of gpsd, and gpsd's reports for them.
namespace drydock::wire::testing {

inline std::filesystem::path gpsd_folder() { return corpora() / "gps/gpsd/daemon"; }

inline std::vector<std::filesystem::path> gpsd_logs() {
  std::vector<std::filesystem::path> logs;
  for (const auto& entry : std::filesystem::directory_iterator{gpsd_folder()}) {
    if (entry.path().extension() == ".log") logs.push_back(entry.path());
  }
  std::ranges::sort(logs);
  return logs;
}

/// The bytes of a log after its head of `#` lines.
inline Buffer gpsd_log(const std::filesystem::path& path) {
  Buffer bytes = read_file(path);
  auto at = bytes.begin();
  while (at != bytes.end() && *at == '#') at = std::find(at, bytes.end(), '\n') + 1;
  bytes.erase(bytes.begin(), at);
  return bytes;
}

/// gpsd's reports of one class for a log. Empty if the folder has no report file.
inline std::vector<nlohmann::json> gpsd_reports(const std::filesystem::path& log,
                                                const std::string& report_class) {
  std::vector<nlohmann::json> reports;
  const Buffer text = read_file(log.string() + ".chk");
  std::istringstream lines{std::string{text.begin(), text.end()}};
  const std::string start = "{\"class\":\"" + report_class + "\"";
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(start)) reports.push_back(nlohmann::json::parse(line));
  }
  return reports;
}

}  // namespace drydock::wire::testing
