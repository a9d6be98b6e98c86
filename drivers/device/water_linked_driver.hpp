#pragma once

#include "drivers/device/stream_driver.hpp"
#include "drivers/wire/water_linked.hpp"

namespace drydock::device {

/// Water Linked DVL: wrz -> BottomVelocity; `valid_at` by the difference of the report's own times
/// of transmission and validity, else by the configured latency. wrx counts while no wrz comes: a
/// DVL that sends both says the same twice. Water track (wrs) is no bottom velocity. Distances
/// along the beams (wru, wrt) do not say of which ping they are, so none go into a measurement.
class WaterLinkedDriver final : public StreamDriver<wire::WaterLinked::max_frame> {
 public:
  explicit WaterLinkedDriver(const DriverOptions& options)
      : StreamDriver(options), mounting_(options.mounting) {}

  void receive(wire::Bytes bytes, Stamp received_at, Output& out) override;

 private:
  struct Arrival {
    Stamp read_at;
    std::size_t bytes, after;
  };

  void on(const wire::water_linked::BottomVelocity& report, const Arrival& arrival, Output& out);
  void on(const wire::water_linked::OldVelocity& report, const Arrival& arrival, Output& out);
  void publish(const wire::water_linked::Report& report, const std::optional<double>& altitude_m,
               const Origin& origin, Output& out) const;
  void heed_heat(bool hot, Output& out);

  Mounting mounting_;
  std::optional<Stamp> new_form_at_;
  bool hot_ = false;
};

}  // namespace drydock::device
