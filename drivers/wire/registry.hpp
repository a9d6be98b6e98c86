#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <string_view>

#include "drivers/wire/can/frame_protocol.hpp"
#include "drivers/wire/can/raw_can.hpp"
#include "drivers/wire/can/slcan.hpp"
#include "drivers/wire/can/xsens.hpp"
#include "drivers/wire/canopen/cia404_imu.hpp"
#include "drivers/wire/canopen/cia404_pressure.hpp"
#include "drivers/wire/canopen/epson_imu.hpp"
#include "drivers/wire/codec.hpp"
#include "drivers/wire/dvl/nortek.hpp"
#include "drivers/wire/dvl/pd0.hpp"
#include "drivers/wire/dvl/pd4.hpp"
#include "drivers/wire/dvl/pd6.hpp"
#include "drivers/wire/dvl/water_linked.hpp"
#include "drivers/wire/j1939/aceinna.hpp"
#include "drivers/wire/j1939/j1939_protocol.hpp"
#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "drivers/wire/nmea2000/nmea2000.hpp"
#include "drivers/wire/ubx/ubx.hpp"
#include "drivers/wire/ubx/ubx_nmea.hpp"

/// Every protocol by its name. For a new protocol, add its include and its entry in one of the
/// lists.
namespace drydock::wire {

template <class... P>
struct ProtocolList {};

/// The contract of codec.hpp.
template <class P>
concept ByteProtocol = requires(Bytes bytes) {
  { P::name } -> std::convertible_to<std::string_view>;
  { P::max_frame } -> std::convertible_to<std::size_t>;
  { P::scan(bytes) } -> std::same_as<Scan>;
  { P::decode(bytes) } -> std::same_as<std::optional<typename P::Message>>;
};

template <ByteProtocol... P>
constexpr void all_are_byte_protocols(ProtocolList<P...>) {}

using BytesProtocols =
    ProtocolList<Nmea0183, Ubx, UbxNmea, Pd0, Pd4, Pd5, Pd6, WaterLinked, Nortek>;

static_assert(requires { all_are_byte_protocols(BytesProtocols{}); });

template <FrameProtocol... P>
constexpr void all_are_frame_protocols(ProtocolList<P...>) {}

using FrameProtocols =
    ProtocolList<Nmea2000, Aceinna, Cia404Imu, Cia404Pressure, EpsonG550, EpsonG552, Xsens, J1939>;

static_assert(requires { all_are_frame_protocols(FrameProtocols{}); });

/// Frames without decoding, for the places that use FrameProtocols.
using FramesAsTheyAre = ProtocolList<RawCan>;

static_assert(requires { all_are_frame_protocols(FramesAsTheyAre{}); });

/// A byte protocol that carries CAN frames: a serial adapter's line.
using FrameCarriers = ProtocolList<Slcan>;

static_assert(requires { all_are_byte_protocols(FrameCarriers{}); });

/// Calls `visit.operator()<P>()` for the protocol with that name. False if the list does not have
/// it.
template <class... P, class Visit>
constexpr bool with_protocol(ProtocolList<P...>, std::string_view name, Visit&& visit) {
  return ((P::name == name && (visit.template operator()<P>(), true)) || ...);
}

}  // namespace drydock::wire
