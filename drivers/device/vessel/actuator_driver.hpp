#pragma once

#include <array>

#include "drivers/device/burst.hpp"
#include "drivers/device/bus/nmea2000_driver.hpp"
#include "drivers/device/vessel/instance_filter.hpp"

namespace drydock::device {

/// Feedback of the actuators on NMEA 2000, one measurement per frame. PGN 127245: instance 0 is the
/// rudder, 1 the stern plane, 2 the bow plane. NMEA 2000 counts a rudder angle to starboard as
/// positive, ActuatorState an angle that turns the vehicle to port. Therefore this driver changes
/// the sign of the rudder, but not of the planes. PGN 127488: shaft speed
/// of the configured instance, or else of the first heard.
/// Consecutive frames of one source were all true before the first was sent.
class ActuatorDriver final : public Nmea2000Driver {
 public:
  explicit ActuatorDriver(const DriverOptions& options);

  void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) override;

 private:
  static constexpr std::size_t surfaces = 3;

  Origin in_burst(const wire::CanFrame& frame, Stamp received_at, std::uint8_t source,
                  std::size_t kind);
  void on(const wire::nmea2000::Rudder& rudder, const Origin& origin, Output& out);
  void on(const wire::nmea2000::Engine& engine, const Origin& origin, Output& out);

  std::array<SourceFilter, surfaces> surface_source_;
  SourceFilter engine_source_;
  InstanceFilter engine_instance_;
  Burst burst_;
  std::uint8_t burst_source_ = 0;
};

}  // namespace drydock::device
