#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/conformance/corpus.hpp"
#include "tests/conformance/reading.hpp"

/// gpsd's regression logs, and gpsd's reports for them (LOG.log.chk). gpsd merges the messages of
/// an epoch into one report, so sets of satellites and positions are compared, not lines.
namespace drydock::conformance {

constexpr Rule mixed_rule{
    "gpsd merges NMEA into UBX",
    "on a line with both protocols gpsd mixes their satellites and positions into one report"};

struct GnssLog {
  std::string bytes;  ///< without the head of # lines
  std::size_t nav_sat = 0, nav_pvt = 0, nmea_epochs = 0, nmea_satellites = 0;
  std::size_t high_rate = 0;      ///< HNR-PVT
  std::size_t foreign_bytes = 0;  ///< neither text nor UBX: another binary protocol
  bool mixed() const { return nav_sat + nav_pvt > 0 && nmea_epochs + nmea_satellites > 0; }
};
GnssLog read_gnss_log(const fs::path& log);

/// gpsd's reports of one class. The other lines of a .chk are sentences that gpsd made.
std::vector<json> gpsd_reports(const fs::path& chk, std::string_view report_class);

/// From a report with "time":"2020-04-07T21:41:48.000Z".
std::optional<std::chrono::milliseconds> gpsd_time_of_day(const json& report);

/// The daemon/*.log for which `holds` is true, each with its .chk.
std::vector<Case> gpsd_logs(const fs::path& folder, bool (*holds)(const GnssLog&));

}  // namespace drydock::conformance
