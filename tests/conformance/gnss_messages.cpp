#include <algorithm>
#include <map>
#include <set>

#include "tests/conformance/comparers.hpp"
#include "tests/conformance/gpsd_log.hpp"
#include "tests/conformance/scan.hpp"

/// For logs without reference values. A scan of checksums counts the valid frames of messages that
/// Drydock reads. Each must be decoded, and no more.
namespace drydock::conformance {

namespace {

using Counts = std::map<std::string, std::size_t>;

const std::map<unsigned, std::string> ubx_messages{
    {0x0102, "NAV-POSLLH"},  {0x0103, "NAV-STATUS"},  {0x0104, "NAV-DOP"},
    {0x0106, "NAV-SOL"},     {0x0107, "NAV-PVT"},     {0x0112, "NAV-VELNED"},
    {0x0120, "NAV-TIMEGPS"}, {0x0121, "NAV-TIMEUTC"}, {0x0130, "NAV-SVINFO"},
    {0x0135, "NAV-SAT"},     {0x0143, "NAV-SIG"},     {0x0161, "NAV-EOE"},
    {0x0213, "RXM-SFRBX"},   {0x0215, "RXM-RAWX"}};
const std::set<std::string_view> nmea_messages{"GGA", "RMC", "GSV", "GSA", "VTG", "ZDA",
                                               "GNS", "GLL", "GST", "HDT", "THS", "HDG",
                                               "HDM", "VHW", "VBW", "VLW"};

Counts scanned(std::string_view bytes) {
  Counts counts;
  for (const std::string_view frame : scan_ubx(bytes))
    if (const auto known = ubx_messages.find(octet(frame, 2) << 8 | octet(frame, 3));
        known != ubx_messages.end())
      ++counts[known->second];
  for (const std::string_view sentence : scan_nmea(bytes)) {
    if (is_proprietary(sentence)) continue;
    const std::string_view address = sentence.substr(1, sentence.find(',') - 1);
    if (address.size() == 5 && nmea_messages.contains(address.substr(2)))
      ++counts[std::string(address.substr(2))];
  }
  return counts;
}

bool is_scanned(const std::string& type) {
  return nmea_messages.contains(type) ||
         std::ranges::any_of(ubx_messages, [&](const auto& m) { return m.second == type; });
}

}  // namespace

std::vector<Case> discover_gnss_logs(const fs::path& folder) {
  auto captures = files_of(folder, ".log");
  for (fs::path& nested : files_of(folder / "daemon", ".log"))
    captures.push_back(std::move(nested));
  std::erase_if(captures,
                [](const fs::path& log) { return scanned(read_gnss_log(log).bytes).empty(); });
  return vectors(captures);
}

void compare_gnss_messages(const Case& one, Score& score) {
  const std::string name = one.capture.filename().string();
  const Counts theirs = scanned(read_gnss_log(one.capture).bytes);
  Counts ours;
  for (const json& message : decode("ubx+nmea0183", one.capture).messages) ++ours[message["type"]];
  for (const auto& [type, count] : theirs) {
    score.matched(std::min(count, ours[type]));
    for (std::size_t i = ours[type]; i < count; ++i) score.missed(name, i + 1, type);
    for (std::size_t i = count; i < ours[type]; ++i) score.unexpected(name, i + 1, type);
  }
  for (const auto& [type, count] : ours)
    if (is_scanned(type) && !theirs.contains(type)) score.unexpected(name, 1, type);
}

}  // namespace drydock::conformance
