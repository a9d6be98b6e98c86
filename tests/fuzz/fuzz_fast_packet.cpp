#include <algorithm>
#include <cstdlib>

#include "drivers/wire/nmea2000/nmea2000.hpp"

using namespace drydock::wire;

/// Every 10 bytes are a frame: source (its two top bits: which PGN), length, data. All frames
/// belong to fast packets.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t step = 10;
  constexpr std::uint32_t pgns[] = {nmea2000::GnssPosition::pgn, nmea2000::SatellitesInView::pgn,
                                    nmea2000::HeadingControl::pgn, nmea2000::DistanceLog::pgn};
  FastPacketAssembler assembler;
  Nmea2000::Decoder decoder;
  for (; size >= step; data += step, size -= step) {
    CanFrame frame = j1939::blank_frame({3, pgns[data[0] >> 6], 255, data[0]});
    frame.size = data[1] % 9;
    std::copy_n(data + 2, frame.size, frame.data.begin());
    const auto whole = assembler.receive(j1939::parse_identifier(frame.id), frame.payload());
    if (whole && whole->data.size() > fast_packet_max_bytes) std::abort();
    decoder.receive(frame);
  }
  return 0;
}
