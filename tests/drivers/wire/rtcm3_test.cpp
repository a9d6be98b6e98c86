#include "drivers/wire/ubx/rtcm3.hpp"

#include <gtest/gtest.h>

#include "drivers/wire/ubx/ubx_nmea.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

namespace drydock::wire::testing {
namespace rtcm3_test {

/// The example of message 1005 in RTCM 10403.
const Buffer station{0xD3, 0x00, 0x13, 0x3E, 0xD7, 0xD3, 0x02, 0x02, 0x98, 0x0E, 0xDE, 0xEF, 0x34,
                     0xB4, 0xBD, 0x62, 0xAC, 0x09, 0x41, 0x98, 0x6F, 0x33, 0x36, 0x0B, 0x98};

/// A frame around a payload of up to 255 bytes.
Buffer frame_around(const Buffer& payload) {
  Buffer frame = Buffer{0xD3, 0x00, static_cast<std::uint8_t>(payload.size())} + payload;
  const std::uint32_t crc = rtcm3::crc24q(frame);
  for (const int shift : {16, 8, 0}) frame.push_back(static_cast<std::uint8_t>(crc >> shift));
  return frame;
}

TEST(Rtcm3, TheStandardsExampleIsAFrame) {
  EXPECT_EQ(rtcm3::crc24q(Bytes{station}.first(22)), 0x360B98u);
  EXPECT_EQ(rtcm3::scan(station), Scan::frame(station.size()));
  for (std::size_t n = 1; n < station.size(); ++n) {
    EXPECT_EQ(rtcm3::scan(Bytes{station}.first(n)).kind, Scan::Kind::need_more) << n;
  }
}

TEST(Rtcm3, ADamagedFrameIsLeftByteByByte) {
  Buffer damaged = station;
  damaged[10] ^= 1;
  EXPECT_EQ(rtcm3::scan(damaged), Scan::skip(1));
  EXPECT_EQ(rtcm3::scan(Buffer{0xD3, 0x04}), Scan::skip(1)) << "a reserved bit is set";
}

TEST(Rtcm3, WhatLooksLikeAnotherProtocolInsideIsPassedOver) {
  const Buffer ubx = fixture("ubx/golden.ubx"), nmea = fixture("nmea0183/golden.nmea");
  // A head that claims 4000 bytes, and a complete sentence.
  const Buffer inside = frame_around(Buffer{0xB5, 0x62, 0x01, 0x07, 0xA0, 0x0F} +
                                     as_bytes("$HCVHW,,,,,0.2,N,0,K*5B\r\n"));
  const auto plain = read_stream<UbxNmea>(ubx + nmea);
  const auto mixed = read_stream<UbxNmea>(station + ubx + inside + nmea + inside, {7});
  EXPECT_EQ(mixed.messages.size(), plain.messages.size());
  EXPECT_EQ(mixed.frames.size(), plain.frames.size() + 3);
  EXPECT_EQ(mixed.counters.bytes_skipped, 0u);
  EXPECT_EQ(mixed.held, 0u);
}

}  // namespace rtcm3_test
}  // namespace drydock::wire::testing
