#include "tests/drivers/wire/golden_protocols.hpp"

#include "drivers/wire/registry.hpp"
#include "tests/drivers/wire/sound_frames.hpp"

namespace drydock::wire::testing {
namespace {

template <class P>
StreamSeen see(Bytes stream, const std::vector<std::size_t>& pieces) {
  auto reading = read_stream<P>(stream, pieces);
  StreamSeen seen{std::move(reading.frames), {}, reading.counters, reading.held};
  seen.keys.reserve(reading.messages.size());
  for (const auto& message : reading.messages) {
    std::visit(
        [&](const auto& m) {
          auto& keys = seen.keys.emplace_back(1, std::string{m.type});
          visit_fields(m, [&](std::string_view key, const auto&) { keys.emplace_back(key); });
        },
        message);
  }
  return seen;
}

template <class P>
GoldenProtocol golden(GoldenProtocol row) {
  row.name = P::name;
  row.max_frame = P::max_frame;
  row.read = see<P>;
  row.decode = [](Bytes frame) { P::decode(frame); };
  return row;
}

/// Without the last frame: a signature that is cut short takes bytes of the frame behind it.
Buffer unsigned_mavlink() {
  Buffer frames = fixture("mavlink/golden.mavlink");
  constexpr std::ptrdiff_t signed_frame = 10 + 9 + 2 + 13;
  return {frames.begin(), frames.end() - signed_frame};
}

}  // namespace

const std::vector<GoldenProtocol>& golden_protocols() {
  static const std::vector<GoldenProtocol> all{
      golden<Nmea0183>(
          {fixture("nmea0183/golden.nmea"), 28, 28, as_bytes("$GPGGA,12"), 9, sound_sentence}),
      golden<Ubx>(
          {fixture("ubx/golden.ubx"), 20, 19, {0xB5, 0x62, 0x01, 0x07, 0x5C, 0x00}, 8, sound_ubx}),
      golden<UbxNmea>({fixture("ubx/golden.ubx") + fixture("nmea0183/golden.nmea"),
                       48,
                       47,
                       {0xB5, 0x62, 0x01, 0x07, 0x5C, 0x00, '$', 'G', 'P'},
                       8,
                       sound_ubx_nmea}),
      golden<Pd0>(
          {fixture("pd0/golden.pd0"), 5, 4, {0x7F, 0x7F, 0xD9, 0x00, 0x00, 0x03}, 20, sound_pd0}),
      golden<Pd4>(
          {fixture("pd4/golden.pd4"), 2, 2, {0x7D, 0x00, 0x2D, 0x00, 0x43}, 20, sound_pd4_or_pd5}),
      golden<Pd5>(
          {fixture("pd5/golden.pd5"), 2, 2, {0x7D, 0x01, 0x56, 0x00, 0x43}, 60, sound_pd4_or_pd5}),
      // The point of a number: no checksum covers the digits.
      golden<Pd6>({fixture("pd6/golden.pd6"), 18, 17, as_bytes(":BI,  +12"), 7, sound_pd6}),
      golden<WaterLinked>({fixture("water-linked/golden.txt"), 20, 19, as_bytes("wrz,0.1,"), 8,
                           sound_water_linked}),
      // A colon: no checksum covers the digits.
      golden<WaterLinkedJson>({fixture("water-linked-json/golden.jsonl"), 21, 19,
                               as_bytes("{\"time\":1,\"vx"), 7, sound_water_linked_json}),
      golden<Nortek>(
          {fixture("nortek/golden.nmea"), 13, 12, as_bytes("$PNORBT7,12"), 9, sound_sentence}),
      golden<NortekAd2cp>({fixture("nortek-ad2cp/golden.nortek-ad2cp"),
                           15,
                           15,
                           {0xA5, 0x0A, 0x1B, 0x10, 0xD4, 0x00, 0x21, 0xCC, 0x41, 0x9D},
                           20,
                           sound_ad2cp}),
      golden<Wayfinder>({fixture("wayfinder/golden.wayfinder"),
                         7,
                         7,
                         {0xAA, 0x10, 0x01, 0x62, 0x00, 0x02},
                         20,
                         sound_wayfinder}),
      golden<Mavlink>({unsigned_mavlink() + fixture("mavlink/autopilot.mavlink"),
                       16,
                       15,
                       {0xFD, 0x2C, 0x00, 0x00, 0x01, 0x01, 0x01, 0x1E},
                       11,
                       sound_mavlink}),
  };
  return all;
}

}  // namespace drydock::wire::testing
