#pragma once

#include "drivers/device/bus/nmea2000_driver.hpp"
#include "drivers/device/gnss/nmea2000_epoch.hpp"

namespace drydock::device {

/// Satellite receiver on NMEA 2000. The messages of one instant have one SID: PGN 129029 (position,
/// time), 129026 (course, speed) and 129539 (dilutions) become one GnssFix when another SID comes
/// or the receiver pauses for 100 ms. PGN 129540 becomes GnssSatellites at once. PGN 129025 has no
/// SID; it becomes a fix of its own only while no PGN 129029 comes.
class Nmea2000GnssDriver final : public Nmea2000Driver {
 public:
  explicit Nmea2000GnssDriver(const DriverOptions& options);

  void receive(const wire::CanFrame& frame, Stamp received_at, Output& out) override;
  void tick(Stamp now, Output& out) override;
  std::optional<Stamp> deadline() const override;
  void restart(Stamp now, Output& out) override;
  void finish(Output& out) override { close(out); }

 private:
  void note_begin(const wire::CanFrame& frame, const Origin& origin);
  /// A fast packet is as old as its first frame.
  Origin of_packet(std::uint8_t source, const Origin& last) const;
  template <class Part>
  void add(const Part& part, const Origin& origin, Output& out);
  void close(Output& out);
  std::optional<Stamp> epoch_ends_at() const;  ///< empty: no epoch is open
  void on(const wire::nmea2000::GnssPosition& position, const Origin& origin, Output& out);
  void on(const wire::nmea2000::CourseAndSpeed& course, const Origin& origin, Output& out);
  void on(const wire::nmea2000::Dilutions& dilutions, const Origin& origin, Output& out);
  void on(const wire::nmea2000::SatellitesInView& sky, const Origin& origin, Output& out);
  void on(const wire::nmea2000::RapidPosition& position, const Origin& origin, Output& out);
  void on(const wire::j1939::AddressClaimed& claim, const Origin& origin, Output& out);

  /// The first frame of the latest fast packet.
  struct Begin {
    std::uint8_t source = 0;
    Origin origin;
  };

  SourceFilter source_;
  Nmea2000Epoch epoch_;
  Begin begin_;
  std::optional<Stamp> position_at_, course_at_;  ///< last PGN 129029 and 129026
  wire::nmea2000::CourseAndSpeed course_;
};

}  // namespace drydock::device
