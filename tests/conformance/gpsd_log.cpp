#include "tests/conformance/gpsd_log.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "tests/conformance/scan.hpp"

namespace drydock::conformance {

namespace {

std::string without_head(std::string text) {
  std::size_t at = 0;
  while (at < text.size() && text[at] == '#')
    at = std::min(text.find('\n', at), text.size() - 1) + 1;
  return text.erase(0, at);
}

std::size_t binary_bytes(std::string_view bytes) {
  return static_cast<std::size_t>(
      std::ranges::count_if(bytes, [](char c) { return static_cast<unsigned char>(c) >= 0x80; }));
}

bool tells_position(std::string_view formatter) {
  constexpr std::array<std::string_view, 4> formatters{"GGA", "RMC", "GNS", "GLL"};
  return std::ranges::find(formatters, formatter) != formatters.end();
}

}  // namespace

GnssLog read_gnss_log(const fs::path& path) {
  GnssLog log{.bytes = without_head(read_text(path))};
  log.foreign_bytes = binary_bytes(log.bytes);
  for (const std::string_view frame : scan_ubx(log.bytes)) {
    log.foreign_bytes -= binary_bytes(frame);
    log.nav_pvt += octet(frame, 2) == 1 && octet(frame, 3) == 0x07;
    log.high_rate += octet(frame, 2) == 0x28 && octet(frame, 3) == 0x00;
    log.nav_sat += octet(frame, 2) == 1 && octet(frame, 3) == 0x35;
  }
  for (const std::string_view sentence : scan_nmea(log.bytes)) {
    if (sentence.size() < 7 || is_proprietary(sentence)) continue;
    log.nmea_epochs += tells_position(sentence.substr(3, 3));
    log.nmea_satellites += sentence.substr(3, 3) == "GSV";
  }
  return log;
}

std::vector<json> gpsd_reports(const fs::path& chk, std::string_view report_class) {
  std::vector<json> found;
  const std::string start = "{\"class\":\"" + std::string(report_class) + "\"";
  std::size_t number = 0;
  for (const std::string& line : lines_of(read_text(chk))) {
    ++number;
    if (!line.starts_with(start)) continue;
    found.push_back(json::parse(line, nullptr, false));
    if (found.back().is_discarded())
      throw Unreadable(chk.filename().string() + ":" + std::to_string(number) + ": no JSON");
  }
  return found;
}

std::optional<std::chrono::milliseconds> gpsd_time_of_day(const json& report) {
  unsigned hours = 0, minutes = 0;
  double seconds = 0;
  const std::string text = report.value("time", "");
  if (std::sscanf(text.c_str(), "%*d-%*d-%*dT%u:%u:%lf", &hours, &minutes, &seconds) != 3)
    return {};
  return std::chrono::milliseconds{std::llround(((hours * 60 + minutes) * 60 + seconds) * 1e3)};
}

std::vector<Case> gpsd_logs(const fs::path& folder, bool (*holds)(const GnssLog&)) {
  auto captures = files_of(folder / "daemon", ".log");
  std::erase_if(captures, [&](const fs::path& log) { return !holds(read_gnss_log(log)); });
  return paired(captures, {}, [](fs::path log) { return log += ".chk"; });
}

}  // namespace drydock::conformance
