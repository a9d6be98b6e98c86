#pragma once

#include "drivers/wire/ubx/ubx.hpp"
#include "hil/emulate/gnss/gnss_epoch.hpp"

/// The UBX messages of an epoch.
namespace drydock::emulate::ublox {

wire::NavPvt nav_pvt(const GnssEpoch& epoch);
wire::NavSat nav_sat(const GnssEpoch& epoch);
wire::NavSol nav_sol(const GnssEpoch& epoch);
/// `uptime_s` since power, `first_fix_s` from power to the first fix.
wire::NavStatus nav_status(const GnssEpoch& epoch, double uptime_s, double first_fix_s);
wire::NavPosllh nav_posllh(const GnssEpoch& epoch);
wire::NavVelned nav_velned(const GnssEpoch& epoch);
wire::NavDop nav_dop(const GnssEpoch& epoch);
wire::NavTimeGps nav_timegps(const GnssEpoch& epoch);

/// NAV-TIMEUTC as a whole frame; returns its bytes, 0 if `out` is too small.
inline constexpr std::uint16_t nav_timeutc = 0x0121;
std::size_t encode_utc(const GnssEpoch& epoch, std::span<std::uint8_t> out);
wire::NavSvinfo nav_svinfo(const GnssEpoch& epoch);

}  // namespace drydock::emulate::ublox
