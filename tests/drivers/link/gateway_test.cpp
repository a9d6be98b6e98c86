#include <gmock/gmock.h>

#include "tests/drivers/link/running.hpp"

/// NMEA 2000 behind gateways that speak in lines, as their makers' manuals show them: YDWG-02,
/// appendix E; Actisense, N2K ASCII; Digital Yacht, iKonvert.
namespace drydock::link::testing {
namespace {

using ::testing::HasSubstr;

class Gateway : public ::testing::Test {
 protected:
  std::unique_ptr<FrameLink> bus(const std::string& query = "") {
    return open_bus(io, "gateway:" + pty + query, Side::driver);
  }
  /// The gateway's own end of the line.
  std::unique_ptr<ByteLink> gateway() { return open(io, pty, Side::device); }
  void say(ByteLink& line, const std::string& text) {
    ASSERT_TRUE(run(io, line.write(bytes(text))));
  }
  std::string heard(ByteLink& line, std::size_t size) {
    const auto got = run(io, read_bytes(line, size));
    return got ? std::string(got->begin(), got->end()) : "";
  }

  Folder folder;
  asio::io_context io;
  std::string pty = "pty:" + folder.file("n2k");
};

TEST_F(Gateway, FramesOfYachtDevicesAreReadFromTheFirstWholeLineOn) {
  const auto device = gateway();
  const auto link = bus();
  const auto first = start(io, link->read());
  settle(io);
  say(*device, "23 01 2F 30\r\n17:33:21.107 R 19F51323 01 2F 30 70 00 2F 30 70\r\n17:33:2");
  ASSERT_TRUE(run_until(io, [&] { return first->outcome.has_value(); }));
  EXPECT_EQ((*first->outcome)->frame.id, 0x19F51323U);
  EXPECT_EQ((*first->outcome)->frame.size, 8);
  EXPECT_EQ((*first->outcome)->frame.data[7], 0x70);
  EXPECT_EQ(link->note(), "") << "the link was opened amid the first line";
  say(*device, "1.141 R 09F805FD FF FC 1F 5B 80 31 29 FF\r\n");
  EXPECT_EQ(run(io, link->read())->frame.id, 0x09F805FDU);
  EXPECT_EQ(link->provenance(), Provenance::emulated);
}

TEST_F(Gateway, AMessageOfActisenseIsTheFramesThatItCameIn) {
  const auto device = gateway();
  const auto link = bus("?format=actisense");
  const auto first = start(io, link->read());
  settle(io);
  // PGN 129029 has a fast packet: 43 bytes are 7 frames, the first with the length.
  say(*device,
      "A173321.107 23FF7 1F805 "
      "01020304050607080910111213141516171819202122232425262728293031323334353637383940"
      "414243\r\n");
  ASSERT_TRUE(run_until(io, [&] { return first->outcome.has_value(); }));
  const wire::CanFrame frame = (*first->outcome)->frame;
  EXPECT_EQ(frame.id, 0x1DF80523U);
  EXPECT_EQ(frame.data[0] & 0x1F, 0);
  EXPECT_EQ(frame.data[1], 43);
  for (int i = 1; i < 7; ++i) EXPECT_EQ(run(io, link->read())->frame.data[0] & 0x1F, i);
}

TEST_F(Gateway, AnOrderGoesOutAndItsEchoIsNoFrameOfAnotherNode) {
  const auto device = gateway();
  const auto link = bus();
  const wire::CanFrame request{
      .id = 0x18EAFFFE, .extended = true, .size = 3, .data = {0x00, 0xEE, 0x00}};
  ASSERT_TRUE(run(io, link->write(request)));
  EXPECT_EQ(heard(*device, 19), "18EAFFFE 00 EE 00\r\n");
  const auto next = start(io, link->read());
  settle(io);
  say(*device, "12:00:00.001 T 18EAFFFE 00 EE 00\r\n12:00:00.010 R 18EEFF23 01 00\r\n");
  ASSERT_TRUE(run_until(io, [&] { return next->outcome.has_value(); }));
  EXPECT_EQ((*next->outcome)->frame.id, 0x18EEFF23U);
}

TEST_F(Gateway, WhatCannotBeSentIsSaid) {
  const auto device = gateway();
  const wire::CanFrame request{.id = 0x18EAFFFE, .extended = true, .size = 3};
  const wire::CanFrame eleven_bits{.id = 0x123, .size = 1};
  EXPECT_THAT(run(io, bus("?format=ikonvert")->write(request)).error().message(),
              HasSubstr("format=ydwg"));
  EXPECT_THAT(run(io, bus()->write(eleven_bits)).error().message(), HasSubstr("29-bit"));
  EXPECT_THAT(run(io, bus("?listen=1")->write(request)).error().message(), HasSubstr("listen=1"));
}

TEST_F(Gateway, LinesOfAnotherFormatAreNoted) {
  const auto device = gateway();
  const auto link = bus();
  const auto none = start(io, link->read());
  settle(io);
  say(*device, "$GPGLL,4916.45,N,12311.12,W,225444,A*31\r\n$GPGLL,4916.45,N,12311.12,W,,A*00\r\n");
  settle(io);
  EXPECT_FALSE(none->outcome.has_value());
  EXPECT_THAT(std::string(link->note()), HasSubstr("2 lines came that are none of format=ydwg"));
  link->close();
  settle(io);
}

TEST_F(Gateway, AnEmulatedOneSaysWhatItsDeviceSendsAndObeys) {
  const auto device = open_bus(io, "gateway:" + pty, Side::device);
  const auto computer = open(io, pty, Side::driver);
  settle(io);
  const wire::CanFrame pressure{
      .id = 0x19FD0A23, .extended = true, .size = 4, .data = {1, 0, 0, 0xAB}};
  ASSERT_TRUE(run(io, device->write(pressure)));
  const std::string said = heard(*computer, 37);
  EXPECT_EQ(said.substr(12), " R 19FD0A23 01 00 00 AB\r\n") << said;
  EXPECT_EQ(said[2], ':');
  EXPECT_EQ(said[8], '.');

  say(*computer, "no order\r\n18EAFFFE 00 EE 00\r\n");
  const auto order = run(io, device->read());
  ASSERT_TRUE(order);
  EXPECT_EQ(order->frame.id, 0x18EAFFFEU);
  EXPECT_EQ(order->frame.size, 3);
  EXPECT_EQ(heard(*computer, 34).substr(12), " T 18EAFFFE 00 EE 00\r\n");
  device->close();
  settle(io);
}

TEST_F(Gateway, OnlyLinesThatTakeFramesAreEmulated) {
  const auto made = open_frames(
      io.get_executor(), parse_uri("gateway:" + pty + "?format=actisense").value(), Side::device);
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message, HasSubstr("allowed: format=ydwg"));
}

}  // namespace
}  // namespace drydock::link::testing
