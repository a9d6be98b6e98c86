#pragma once

#include "drivers/device/dvl/water_linked_dialogue.hpp"
#include "drivers/device/stream_driver.hpp"
#include "drivers/wire/dvl/water_linked.hpp"

namespace drydock::device {

/// Water Linked DVL: wrz -> BottomVelocity; `valid_at` by the difference of the report's own times
/// of transmission and validity, else by the configured latency. wrx counts while no wrz comes: a
/// DVL that sends both says the same twice. Water track (wrs) is no bottom velocity. Distances
/// along the beams (wru, wrt) do not say of which ping they are, so none go into a measurement.
/// Sets the DVL up when the link opens and after a silence, in which it may have lost its power and
/// with it what was set (WaterLinkedDialogue). While that differs from the rig file, or is not
/// known to agree yet, there are no velocities: they would be those of other axes or another sound
/// speed.
class WaterLinkedDriver final : public StreamDriver<wire::WaterLinked::max_frame> {
 public:
  explicit WaterLinkedDriver(const DriverOptions& options)
      : StreamDriver(options), mounting_(options.mounting), dialogue_(options.dvl.water_linked) {}

  void receive(wire::Bytes bytes, Stamp received_at, Output& out) override;
  void restart(Stamp now, Output& out) override;
  void tick(Stamp now, Output& out) override { dialogue_.tick(now, out); }
  std::optional<Stamp> deadline() const override { return dialogue_.deadline(); }

 private:
  struct Arrival {
    Stamp read_at;
    std::size_t bytes, after;
  };

  void on(const wire::water_linked::BottomVelocity& report, const Arrival& arrival, Output& out);
  void on(const wire::water_linked::OldVelocity& report, const Arrival& arrival, Output& out);
  void publish(const wire::water_linked::Report& report, const std::optional<double>& altitude_m,
               const Origin& origin, Output& out) const;
  void heed_silence(Stamp now, Output& out);
  void heed_heat(bool hot, Output& out);

  Mounting mounting_;
  WaterLinkedDialogue dialogue_;
  std::optional<Stamp> new_form_at_, heard_at_;
  bool hot_ = false;
};

}  // namespace drydock::device
