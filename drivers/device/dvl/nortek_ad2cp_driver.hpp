#pragma once

#include <string_view>

#include "drivers/device/dvl/ad2cp_solution.hpp"
#include "drivers/device/dvl/dvl_finish.hpp"
#include "drivers/device/dvl/echo_times.hpp"
#include "drivers/device/stream_driver.hpp"
#include "drivers/wire/dvl/nortek_ad2cp.hpp"

namespace drydock::device {

/// Nortek DVL with binary records: each bottom track (1B) becomes BottomVelocity. `valid_at`
/// follows from the age that the record tells, otherwise from the configured latency. The altitude
/// is that of a level DVL, because the record has no tilt. Bottom track of a Signature (17) gives
/// ranges, altitude and attitude, and a velocity if the rig says `velocity_of`: no document at hand
/// tells its sign. Water track (1D) is no bottom velocity. What is missing from an incomplete
/// velocity is reported once, until something else is missing.
class NortekAd2cpDriver final : public StreamDriver<wire::NortekAd2cp::max_frame> {
 public:
  explicit NortekAd2cpDriver(const DriverOptions& options)
      : StreamDriver(options, wire::NortekAd2cp::scan),
        of_bed_(options.dvl.velocity_of_bed),
        mounting_(options.mounting),
        finish_(options) {}

 private:
  void on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) override;
  void on(const wire::ad2cp::BottomTrack& record, const Arrival& arrival, Output& out);
  void on(const wire::ad2cp::SignatureBottomTrack& record, const Arrival& arrival, Output& out);
  Origin origin_of(const Ad2cpSolution& solution, const wire::ad2cp::BottomTrack& record,
                   const Arrival& arrival);
  void heed(std::string_view trouble, Output& out);

  std::optional<bool> of_bed_;  ///< what a Signature's velocity is of; empty: not known
  Mounting mounting_;
  DvlFinish finish_;
  EchoTimes echo_;
  std::string_view trouble_;
};

}  // namespace drydock::device
