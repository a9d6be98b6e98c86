#pragma once

#include "drivers/device/dvl/dvl_finish.hpp"
#include "drivers/device/dvl/water_linked_json_dialogue.hpp"
#include "drivers/device/dvl/water_linked_report.hpp"
#include "drivers/device/stream_driver.hpp"
#include "drivers/measurement/earlier.hpp"
#include "drivers/wire/dvl/water_linked_json.hpp"

namespace drydock::device {

/// Water Linked DVL over TCP: a velocity report becomes BottomVelocity, with its covariance, its
/// figure of merit and the vertical component of each beam's distance. `valid_at` follows from the
/// difference between the report's own times of transmission and validity, otherwise from the
/// configured latency. Water track and dead reckoning are counted as values without a measurement.
/// Like WaterLinkedDriver it sets up the DVL when the link opens and after a silence, and publishes
/// no velocities while the settings are not confirmed.
class WaterLinkedJsonDriver final : public StreamDriver<wire::WaterLinkedJson::max_frame> {
 public:
  explicit WaterLinkedJsonDriver(const DriverOptions& options)
      : StreamDriver(options, wire::WaterLinkedJson::scan),
        mounting_(options.mounting),
        finish_(options),
        dialogue_(options.dvl.water_linked) {}

  void restart(Stamp now, Output& out) override;
  void tick(Stamp now, Output& out) override {
    StreamDriver::tick(now, out);
    dialogue_.tick(now, out);
  }
  std::optional<Stamp> deadline() const override {
    return measurement::earlier(StreamDriver::deadline(), dialogue_.deadline());
  }

 private:
  using Velocity = wire::water_linked_json::Velocity;

  void on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) override;
  void on(const Velocity& report, const Arrival& arrival, Output& out);
  void on(const wire::water_linked_json::WaterVelocity&, const Arrival&, Output& out);
  void on(const wire::water_linked_json::Position&, const Arrival&, Output& out);
  void on(const wire::water_linked_json::Response& answer, const Arrival& arrival, Output& out);
  void add_velocity(const Velocity& report, measurement::BottomVelocity& to) const;
  void heed_silence(Stamp now, Output& out);
  void heed_heat(bool hot, Output& out);

  Mounting mounting_;
  DvlFinish finish_;
  WaterLinkedJsonDialogue dialogue_;
  ReportAge age_;
  std::optional<Stamp> heard_at_;
  bool hot_ = false;
};

}  // namespace drydock::device
