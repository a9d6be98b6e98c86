#include "drivers/wire/can/gateway_line.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

/// Lines of the manual of the YDWG-02, appendix E. The reader of captures and canboatjs read such
/// lines in tests of their own.
namespace drydock::wire::gateway_line {
namespace gateway_line_test {

using namespace std::chrono_literals;

const CanFrame position_rapid{.id = 0x19F51323,
                              .extended = true,
                              .size = 7,
                              .data = {0x01, 0x2F, 0x30, 0x70, 0x00, 0x2F, 0x30}};

template <class Encode>
std::string text_of(Encode&& encode) {
  std::array<std::uint8_t, longest> out;
  const std::size_t size = encode(std::span(out));
  return {out.begin(), out.begin() + static_cast<std::ptrdiff_t>(size)};
}

TEST(GatewayLine, SaysWhenAFrameCameFromTheBusOrWentThere) {
  const auto said = [](Way way) {
    return text_of(
        [&](auto out) { return encode(position_rapid, 17h + 33min + 21s + 107ms, way, out); });
  };
  EXPECT_EQ(said(Way::received), "17:33:21.107 R 19F51323 01 2F 30 70 00 2F 30\r\n");
  EXPECT_EQ(said(Way::sent), "17:33:21.107 T 19F51323 01 2F 30 70 00 2F 30\r\n");
}

TEST(GatewayLine, AnOrderIsThatWithoutTimeAndLetter) {
  const auto order = text_of([](auto out) { return encode_order(position_rapid, out); });
  EXPECT_EQ(order, "19F51323 01 2F 30 70 00 2F 30\r\n");
  EXPECT_EQ(parse_order("19F51323 01 2f 30 70 00 2F 30 "), position_rapid);
}

TEST(GatewayLine, ALineThatIsNoOrderIsNone) {
  for (const char* line : {"", "19F51323 1", "19F51323 01 02 03 04 05 06 07 08 09", "3F51323 01",
                           "39F51323 01", "17:33:21.107 R 19F51323 01", "19F51323 0X"})
    EXPECT_FALSE(parse_order(line)) << line;
}

TEST(GatewayLine, OnlyDataFramesWith29BitsAreCarried) {
  CanFrame frame = position_rapid;
  EXPECT_TRUE(carries(frame));
  frame.extended = false;
  EXPECT_EQ(text_of([&](auto out) { return encode_order(frame, out); }), "");
  frame = position_rapid;
  frame.fd = true;
  EXPECT_EQ(text_of([&](auto out) { return encode(frame, 0ms, Way::sent, out); }), "");
}

}  // namespace gateway_line_test
}  // namespace drydock::wire::gateway_line
