#pragma once

#include <chrono>

#include "drivers/measurement/measurement.hpp"
#include "hil/emulate/sampling_device.hpp"
#include "hil/sky/dilution.hpp"

namespace drydock::emulate {

/// The knowledge of a receiver at one epoch. In a cold start it finds one satellite after another,
/// the strongest first. It knows the time after half of this search, and uses satellites once it
/// has a fix. Under water it has no fix and no satellites, but its clock runs on. It also has no
/// fix if the satellites in use do not determine one (sky::dilution).
struct GnssEpoch {
  measurement::GnssFix fix;
  measurement::GnssSatellites sky;
  std::optional<sky::Dilution> dilution;     ///< only with a fix
  bool time_is_known = true;                 ///< false in a cold start until the time is received
  std::chrono::year_month_day date;          ///< UTC
  std::chrono::nanoseconds time_of_day{};    ///< UTC
  int week = 0;                              ///< GPS, not modulo 1024
  std::chrono::seconds leap_seconds{};       ///< GPS - UTC
  std::chrono::milliseconds time_of_week{};  ///< GPS time
};

/// Course over ground, [0, 2 pi).
double course_rad(const Eigen::Vector3d& velocity_ned);

/// The measuring part of a receiver, common to all protocols. Primary errors are those of the
/// position (m: north, east, down), secondary errors those of the velocity.
class GnssSensor {
 public:
  explicit GnssSensor(const DeviceSetup& setup);
  /// The receiver forgets its satellites, and has a fix again after `until_fix`.
  void search_again(Stamp at, std::chrono::nanoseconds until_fix);
  /// A receiver that does not receive GPS has no fix; its clock runs on.
  void receive_gps(bool received) { receives_gps_ = received; }

  GnssEpoch measure(const motion::Truth& truth, const sensor::Mounting& mounting);

 private:
  void add_errors(measurement::GnssFix& fix);
  void hide(measurement::GnssSatellites& sky) const;
  void search(GnssEpoch& epoch, Stamp at) const;

  std::shared_ptr<const Condition> condition_;
  Stamp boot_;
  std::chrono::nanoseconds first_fix_;
  bool receives_gps_ = true;
  double lowest_cno_dbhz_;
  std::shared_ptr<sensor::Sky> sky_;
  sensor::ErrorModel position_errors_, velocity_errors_;
  double horizontal_accuracy_m_, vertical_accuracy_m_, speed_accuracy_mps_;
};

}  // namespace drydock::emulate
