#pragma once

#include "drivers/device/dvl/dvl_finish.hpp"
#include "drivers/device/dvl/water_linked_dialogue.hpp"
#include "drivers/device/dvl/water_linked_report.hpp"
#include "drivers/device/stream_driver.hpp"
#include "drivers/measurement/earlier.hpp"
#include "drivers/wire/dvl/water_linked.hpp"

namespace drydock::device {

/// Water Linked DVL: wrz becomes BottomVelocity. `valid_at` follows from the difference between the
/// report's own times of transmission and validity, otherwise from the configured latency. The
/// driver uses wrx only while no wrz comes: a DVL that sends both gives the same data twice. Water
/// track (wrs) is no bottom velocity. Distances along the beams (wru, wrt) do not name their ping,
/// so no measurement uses them.
/// The driver sets up the DVL when the link opens and after a silence, because the DVL may have
/// lost its power and its settings (WaterLinkedDialogue). It publishes no velocities while the
/// settings differ from the rig file or are not confirmed: they could have other axes or another
/// sound speed.
class WaterLinkedDriver final : public StreamDriver<wire::WaterLinked::max_frame> {
 public:
  explicit WaterLinkedDriver(const DriverOptions& options)
      : StreamDriver(options, wire::WaterLinked::scan),
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
  void on_frame(wire::Bytes frame, const Arrival& arrival, Output& out) override;
  void on(const wire::water_linked::BottomVelocity& report, const Arrival& arrival, Output& out);
  void on(const wire::water_linked::OldVelocity& report, const Arrival& arrival, Output& out);
  measurement::BottomVelocity sample_of(const wire::water_linked::Report& report,
                                        const std::optional<double>& altitude_m,
                                        const Origin& origin) const;
  void heed_silence(Stamp now, Output& out);
  void heed_heat(bool hot, Output& out);

  Mounting mounting_;
  DvlFinish finish_;
  WaterLinkedDialogue dialogue_;
  ReportAge age_;
  std::optional<Stamp> new_form_at_, heard_at_;
  bool hot_ = false;
};

}  // namespace drydock::device
