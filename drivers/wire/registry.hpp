#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <string_view>
#include <tuple>

#include "drivers/wire/can/frame_protocol.hpp"
#include "drivers/wire/can/raw_can.hpp"
#include "drivers/wire/can/sbg.hpp"
#include "drivers/wire/can/slcan.hpp"
#include "drivers/wire/can/xsens.hpp"
#include "drivers/wire/canopen/cia402.hpp"
#include "drivers/wire/canopen/cia404_imu.hpp"
#include "drivers/wire/canopen/cia404_pressure.hpp"
#include "drivers/wire/canopen/epson_imu.hpp"
#include "drivers/wire/codec.hpp"
#include "drivers/wire/dvl/nortek.hpp"
#include "drivers/wire/dvl/nortek_ad2cp.hpp"
#include "drivers/wire/dvl/pd0.hpp"
#include "drivers/wire/dvl/pd4.hpp"
#include "drivers/wire/dvl/pd6.hpp"
#include "drivers/wire/dvl/water_linked.hpp"
#include "drivers/wire/dvl/water_linked_json.hpp"
#include "drivers/wire/dvl/wayfinder.hpp"
#include "drivers/wire/j1939/aceinna.hpp"
#include "drivers/wire/j1939/j1939_protocol.hpp"
#include "drivers/wire/j1939/mv5.hpp"
#include "drivers/wire/mavlink/mavlink.hpp"
#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "drivers/wire/nmea2000/nmea2000.hpp"
#include "drivers/wire/protocols.hpp"
#include "drivers/wire/ubx/ubx.hpp"
#include "drivers/wire/ubx/ubx_nmea.hpp"

/// The table of protocols: the codec of each with its facts. For a new protocol, add its include
/// and its row.
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

template <class Codec>
struct Row {
  Protocol facts;
};

template <ByteProtocol Codec>
constexpr Row<Codec> bytes(Protocol facts) {
  facts.name = Codec::name;
  facts.travels = Travels::as_bytes;
  return {facts};
}

template <FrameProtocol Codec>
constexpr Row<Codec> frames(Protocol facts) {
  facts.name = Codec::name;
  facts.travels = Travels::as_frames;
  if (facts.place == Place::no) facts.place = Place::of_bus;
  return {facts};
}

inline constexpr std::tuple byte_protocols{
    bytes<Ubx>({.kinds = Kind::gnss,
                .checksum = "Fletcher-8",
                .clock = DeviceClock::yes,
                .settings = Settings::refusable,
                .place = Place::yes}),
    bytes<Nmea0183>({.kinds = {Kind::gnss, Kind::emlog, Kind::attitude},
                     .checksum = "XOR",
                     .clock = DeviceClock::of_receiver,
                     .place = Place::of_receiver}),
    bytes<UbxNmea>({.kinds = Kind::gnss,
                    .checksum = "of each",
                    .clock = DeviceClock::yes,
                    .place = Place::yes,
                    .emulated = false}),
    bytes<Pd0>({.kinds = Kind::dvl, .checksum = "16-bit sum", .clock = DeviceClock::yes}),
    bytes<Pd4>({.kinds = Kind::dvl, .checksum = "16-bit sum", .clock = DeviceClock::yes}),
    bytes<Pd5>({.kinds = Kind::dvl, .checksum = "16-bit sum", .clock = DeviceClock::yes}),
    bytes<Pd6>({.kinds = Kind::dvl, .clock = DeviceClock::yes}),
    bytes<WaterLinked>({.kinds = Kind::dvl,
                        .checksum = "CRC-8",
                        .clock = DeviceClock::yes,
                        .settings = Settings::refusable,
                        .tells_heat = true}),
    bytes<WaterLinkedJson>({.kinds = Kind::dvl,
                            .clock = DeviceClock::yes,
                            .settings = Settings::refusable,
                            .tells_heat = true}),
    bytes<Nortek>({.kinds = Kind::dvl, .checksum = "XOR", .clock = DeviceClock::yes}),
    bytes<NortekAd2cp>({.kinds = Kind::dvl,
                        .checksum = "two 16-bit sums",
                        .clock = DeviceClock::yes,
                        .settings = Settings::refusable}),
    bytes<Wayfinder>({.kinds = Kind::dvl,
                      .checksum = "16-bit sum",
                      .clock = DeviceClock::yes,
                      .settings = Settings::refusable}),
    bytes<Mavlink>({.checksum = "CRC-16/MCRF4XX", .place = Place::yes}),
};

inline constexpr std::tuple frame_protocols{
    frames<Nmea2000>(
        {.kinds = {Kind::depth, Kind::actuator, Kind::gnss, Kind::emlog, Kind::attitude},
         .clock = DeviceClock::of_receiver,
         .network = Network::j1939}),
    frames<Aceinna>({.kinds = Kind::imu, .settings = Settings::obeyed, .network = Network::j1939}),
    frames<Mv5>({.kinds = Kind::imu, .network = Network::j1939}),
    frames<Cia404Imu>(
        {.kinds = Kind::imu, .settings = Settings::refusable, .network = Network::canopen}),
    frames<Cia404Pressure>(
        {.kinds = Kind::depth, .settings = Settings::refusable, .network = Network::canopen}),
    frames<Cia402>(
        {.kinds = Kind::actuator, .settings = Settings::refusable, .network = Network::canopen}),
    frames<EpsonG550>(
        {.kinds = Kind::imu, .settings = Settings::refusable, .network = Network::canopen}),
    frames<EpsonG552>(
        {.kinds = Kind::imu, .settings = Settings::refusable, .network = Network::canopen}),
    frames<Xsens>(
        {.kinds = Kind::imu, .clock = DeviceClock::yes, .place = Place::under_any_identifier}),
    frames<Sbg>(
        {.kinds = Kind::imu, .clock = DeviceClock::yes, .place = Place::under_any_identifier}),
    frames<J1939>({.network = Network::j1939}),
};

/// Frames without decoding, for the places that use FrameProtocols.
inline constexpr std::tuple frames_as_they_are{frames<RawCan>({})};

/// A byte protocol that carries CAN frames: a serial adapter's line.
inline constexpr std::tuple frame_carriers{bytes<Slcan>({})};

template <class... Codec>
ProtocolList<Codec...> codecs_of(const std::tuple<Row<Codec>...>& rows);

using BytesProtocols = decltype(codecs_of(byte_protocols));
using FrameProtocols = decltype(codecs_of(frame_protocols));
using FramesAsTheyAre = decltype(codecs_of(frames_as_they_are));
using FrameCarriers = decltype(codecs_of(frame_carriers));

/// Calls `visit.operator()<P>()` for the protocol with that name. False if the list does not have
/// it.
template <class... P, class Visit>
constexpr bool with_protocol(ProtocolList<P...>, std::string_view name, Visit&& visit) {
  return ((P::name == name && (visit.template operator()<P>(), true)) || ...);
}

}  // namespace drydock::wire
