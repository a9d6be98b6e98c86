#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <vector>

/// gpsd (the Debian package of that name) as the other end of an emulated receiver's line.
namespace drydock::peer {

using Reports = std::vector<nlohmann::json>;

bool gpsd_is_installed();

/// Starts gpsd on a pty of ours, writes the stream there at once and gives what gpsd reports over
/// TCP on the loopback until `enough`, at most for half a minute. At once is as good as paced:
/// gpsd takes times and the ends of epochs from the messages and never from the clock, and a pty
/// holds 64 KiB.
Reports reports_of_gpsd(const std::vector<std::uint8_t>& stream,
                        const std::function<bool(const Reports&)>& enough);

/// The reports of one class.
Reports of_class(const Reports& reports, std::string_view report_class);

}  // namespace drydock::peer
