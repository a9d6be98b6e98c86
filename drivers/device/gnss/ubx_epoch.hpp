#pragma once

#include <chrono>
#include <optional>

#include "drivers/device/gnss/ubx_satellite_list.hpp"
#include "drivers/device/timing.hpp"
#include "drivers/wire/ubx/ubx_solution.hpp"
#include "drivers/wire/ubx/ubx_time.hpp"

namespace drydock::device {

/// The fix type that follows from a receiver's fix type and its gnssFixOK.
measurement::FixType fix_type(wire::UbxFixType type, bool fix_ok);

/// Empty without a fix of position. `carrier_solution` is carrSoln of NAV-PVT: 0 none, 1 float, 2
/// fixed. `differential` is its diffSoln: corrections of a base or of a satellite (SBAS).
std::optional<measurement::FixQuality> fix_quality(measurement::FixType type, bool differential,
                                                   unsigned carrier_solution = 0);

/// Joins the parts of one epoch of a receiver without NAV-PVT or NAV-SAT into one fix and one list
/// of satellites. The parts are NAV-SOL, STATUS, POSLLH, VELNED, DOP, TIMEGPS and TIMEUTC; SVINFO
/// or SIG. They share one iTOW; the driver passes only parts of one iTOW.
class UbxEpoch {
 public:
  bool empty() const { return !began_; }

  void add(const wire::NavSol& m, const Origin& o) { begin(o), sol_ = m; }
  void add(const wire::NavStatus& m, const Origin& o) { begin(o), status_ = m; }
  void add(const wire::NavPosllh& m, const Origin& o) { begin(o), posllh_ = m; }
  void add(const wire::NavVelned& m, const Origin& o) { begin(o), velned_ = m; }
  void add(const wire::NavDop& m, const Origin& o) { begin(o), dop_ = m; }
  void add(const wire::NavTimeGps& m, const Origin& o) { begin(o), time_gps_ = m; }
  void add(const wire::NavTimeUtc& m, const Origin& o) { begin(o), time_utc_ = m; }
  void add(const wire::NavSvinfo& m, const Origin& o);
  void add(const wire::NavSig& m, const Origin& o);  ///< SVINFO has more data and replaces it

  /// valid_at is that of the epoch's first message, received_at that of its last. A position or
  /// velocity is published only if NAV-SOL or NAV-STATUS calls the fix valid. POSLLH and VELNED
  /// take precedence over the ECEF values of NAV-SOL. Empty without any of these four messages.
  std::optional<measurement::GnssFix> fix() const;
  std::optional<measurement::GnssSatellites> satellites() const;

  void clear() { *this = {}; }

 private:
  void begin(const Origin& origin);
  bool vouched_for() const;
  void fill_position(measurement::GnssFix& fix) const;
  void fill_velocity(measurement::GnssFix& fix) const;
  std::optional<measurement::Stamp> utc() const;

  std::optional<Origin> began_;
  std::optional<wire::NavSol> sol_;
  std::optional<wire::NavStatus> status_;
  std::optional<wire::NavPosllh> posllh_;
  std::optional<wire::NavVelned> velned_;
  std::optional<wire::NavDop> dop_;
  std::optional<wire::NavTimeGps> time_gps_;
  std::optional<wire::NavTimeUtc> time_utc_;
  bool has_channels_ = false;
  std::optional<SatelliteList> satellites_;
};

}  // namespace drydock::device
