#pragma once

#include <optional>
#include <string_view>
#include <variant>

#include "drivers/wire/j1939/j1939_protocol.hpp"
#include "drivers/wire/nmea2000/actuator_messages.hpp"
#include "drivers/wire/nmea2000/depth_messages.hpp"
#include "drivers/wire/nmea2000/fast_packet.hpp"
#include "drivers/wire/nmea2000/gnss_messages.hpp"
#include "drivers/wire/nmea2000/speed_messages.hpp"
#include "drivers/wire/nmea2000/vessel_messages.hpp"

namespace drydock::wire {

/// NMEA 2000: 29-bit identifiers of J1939, 250 kbit/s, single frames, fast packets and
/// the transport protocol.
struct Nmea2000 {
  static constexpr std::string_view name = "nmea2000";
  using Message =
      std::variant<nmea2000::Pressure, nmea2000::Temperature, nmea2000::WaterDepth,
                   nmea2000::WaterAndAir, nmea2000::Environment, nmea2000::Rudder, nmea2000::Engine,
                   nmea2000::HeadingControl, nmea2000::VesselHeading, nmea2000::RateOfTurn,
                   nmea2000::Heave, nmea2000::Attitude, nmea2000::MagneticVariation,
                   nmea2000::Speed, nmea2000::DistanceLog, nmea2000::SystemTime,
                   nmea2000::RapidPosition, nmea2000::CourseAndSpeed, nmea2000::GnssPosition,
                   nmea2000::Dilutions, nmea2000::SatellitesInView, j1939::AddressClaimed,
                   j1939::Request, j1939::CommandedAddress>;

  class Decoder {
   public:
    /// A listener without a clock leaves `now` out; see FastPacketAssembler.
    std::optional<Message> receive(const CanFrame& frame, std::chrono::nanoseconds now = {});
    void finish();  ///< no more frames come: messages that wait for some are lost
    const StreamCounters& counters() const { return counters_; }

   private:
    std::optional<Message> receive_part(const j1939::Identifier& id, const CanFrame& frame,
                                        std::chrono::nanoseconds now);
    std::optional<Message> receive_packet(const j1939::Identifier& id, const CanFrame& frame,
                                          std::chrono::nanoseconds now);
    std::optional<Message> receive_whole(const j1939::Identifier& id, Bytes message);

    FastPacketAssembler assembler_;
    j1939::TransportReceiver transport_;
    StreamCounters counters_;
  };
};

}  // namespace drydock::wire
