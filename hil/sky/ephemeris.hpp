#pragma once

#include <cstdint>

#include "hil/sky/gps_time.hpp"

namespace drydock::sky {

inline constexpr int highest_prn = 32;

/// One GPS broadcast record (LNAV subframes 1 to 3) with the names of IS-GPS-200, table 20-III.
/// Units are SI and radians. RINEX has already converted the semicircles of the message.
struct Ephemeris {
  std::uint8_t prn = 0;  ///< 1 to highest_prn
  int line = 0;          ///< line of the file at which the record begins

  GpsTime toc;                                 ///< time of the clock polynomial
  double af0_s = 0, af1 = 0, af2_ps = 0;       ///< clock: s, s/s, s/s2
  GpsTime toe;                                 ///< time of the orbit
  double sqrt_a = 0;                           ///< root of the semi-major axis, m^(1/2)
  double e = 0;                                ///< eccentricity
  double m0_rad = 0, delta_n_radps = 0;        ///< mean anomaly at toe, correction of the mean
                                               ///< motion
  double omega_rad = 0;                        ///< argument of perigee
  double omega0_rad = 0, omega_dot_radps = 0;  ///< longitude of the node at the week's start, rate
  double i0_rad = 0, idot_radps = 0;           ///< inclination at toe, rate
  double cuc_rad = 0, cus_rad = 0;             ///< second harmonics: argument of latitude,
  double crc_m = 0, crs_m = 0;                 ///< radius,
  double cic_rad = 0, cis_rad = 0;             ///< inclination
  unsigned health = 0;                         ///< 0: healthy

  bool healthy() const { return health == 0; }
};

}  // namespace drydock::sky
