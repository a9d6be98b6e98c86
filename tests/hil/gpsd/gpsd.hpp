#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

/// gpsd (the Debian package) at the other end of an emulated receiver's line.
namespace drydock::peer {

using Reports = std::vector<nlohmann::json>;

bool gpsd_is_installed();

/// Starts gpsd on a pty of the test, writes the whole stream at once and returns gpsd's reports
/// over TCP on the loopback until `enough`, for at most half a minute. The stream need not be
/// paced: gpsd takes times and the ends of epochs from the messages, not from the clock, and a pty
/// holds 64 KiB.
Reports reports_of_gpsd(const std::vector<std::uint8_t>& stream,
                        const std::function<bool(const Reports&)>& enough);

/// The reports of one class.
Reports of_class(const Reports& reports, std::string_view report_class);

}  // namespace drydock::peer
