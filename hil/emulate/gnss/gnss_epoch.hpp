#pragma once

#include <chrono>

#include "drivers/measurement/measurement.hpp"
#include "hil/emulate/sampling_device.hpp"
#include "hil/sky/dilution.hpp"

namespace drydock::emulate {

/// What a receiver knows at one epoch. A cold start finds the strongest satellite first, one after
/// the other; it knows the time from half of the way on and uses satellites when it has its fix.
/// Under water: no fix, no satellites; its clock runs on. No fix either where the satellites in use
/// do not give one (sky::dilution).
struct GnssEpoch {
  measurement::GnssFix fix;
  measurement::GnssSatellites sky;
  std::optional<sky::Dilution> dilution;     ///< with a fix
  bool time_is_known = true;                 ///< not before a cold start has heard it
  std::chrono::year_month_day date;          ///< UTC
  std::chrono::nanoseconds time_of_day{};    ///< UTC
  std::chrono::milliseconds time_of_week{};  ///< GPS time
};

/// Course over ground, [0, 2 pi).
double course_rad(const Eigen::Vector3d& velocity_ned);

/// The receiver's measuring side, the same for every protocol. Primary errors are the position's
/// (m: north, east, down), secondary the velocity's.
class GnssSensor {
 public:
  explicit GnssSensor(const DeviceSetup& setup);
  GnssEpoch measure(const motion::Truth& truth, const sensor::Mounting& mounting);

 private:
  void add_errors(measurement::GnssFix& fix);
  void hide(measurement::GnssSatellites& sky) const;
  void search(GnssEpoch& epoch, Stamp at) const;

  std::shared_ptr<const Condition> condition_;
  Stamp boot_;
  std::chrono::nanoseconds first_fix_;
  double lowest_cno_dbhz_;
  std::shared_ptr<sensor::Sky> sky_;
  sensor::ErrorModel position_errors_, velocity_errors_;
  double horizontal_accuracy_m_, vertical_accuracy_m_, speed_accuracy_mps_;
};

}  // namespace drydock::emulate
