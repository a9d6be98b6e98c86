#include <gmock/gmock.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <functional>

#include "drivers/capture/line_file.hpp"
#include "drivers/capture/stream_order.hpp"
#include "drivers/wire/bytes.hpp"
#include "tests/drivers/capture/captures.hpp"

/// Packets of a network: cooked ones with CAN, and lines over UDP and TCP. The files of
/// fixtures/capture/network are text2pcap's (NOTE.md).
namespace drydock::capture::testing {
namespace network_test {

using ::testing::HasSubstr;
using wire::testing::as_bytes;

std::string file(const std::string& name) {
  return DRYDOCK_SOURCE_DIR "/fixtures/capture/network/" + name;
}

std::string all_of(LineFile& line) {
  std::string text;
  while (const auto read = line.next()) text += wire::testing::as_text(read->bytes);
  return text;
}

/// The CAN packets of le_us.pcap, as a computer of that byte order has them when all interfaces are
/// recorded at once (SLL: tcpdump.org/linktypes/LINKTYPE_LINUX_SLL.html).
Buffer cooked(std::uint32_t link_type) {
  const Buffer plain = wire::testing::fixture("capture/le_us.pcap");
  Buffer out(plain.begin(), plain.begin() + 24);
  wire::store_le<std::uint32_t>(out, 20, link_type);
  for (std::size_t at = 24; at < plain.size();) {
    const std::size_t size = wire::load_le<std::uint32_t>(plain, at + 8);
    Buffer head(link_type == 113 ? 16 : 20), packet(plain.begin() + at, plain.begin() + at + 16);
    head[link_type == 113 ? 15 : 1] = size > 16 ? 0x0D : 0x0C;
    for (const std::size_t length : {8, 12})
      wire::store_le<std::uint32_t>(packet, length, static_cast<std::uint32_t>(size + head.size()));
    Buffer body(plain.begin() + at + 16, plain.begin() + at + 16 + size);
    std::reverse(body.begin(), body.begin() + 4);
    out = out + packet + head + body;
    at += 16 + size;
  }
  return out;
}

TEST(CookedPackets, OfACanBusGiveItsFrames) {
  const Outcome plain = read_capture(wire::testing::fixture("capture/le_us.pcap"));
  for (const std::uint32_t link_type : {113u, 276u}) {
    const Outcome outcome = read_capture(cooked(link_type));
    EXPECT_EQ(outcome.format, "pcap");
    ASSERT_EQ(outcome.records.size(), 8u) << link_type;
    for (std::size_t i = 0; i < 8; ++i)
      EXPECT_EQ(outcome.records[i].frame, plain.records[i].frame) << i;
  }
}

TEST(NetworkLines, OfUdpAreItsDatagrams) {
  for (const char* name : {"udp-ethernet.pcap", "udp-sll.pcap"}) {
    LineFile line(file(name), false);
    EXPECT_EQ(all_of(line), "$GPHDT,75.5664,T*36\r\n$GNTHS,244.17,A*1D\r\n") << name;
    EXPECT_EQ(line.trouble(), "");
    EXPECT_EQ(line.lines()[0].name, "10.1.1.1:50000");
  }
}

TEST(NetworkLines, OfTcpNeedAChoiceWhereBothSidesSpeak) {
  LineFile unchosen(file("tcp.pcap"), false);
  EXPECT_EQ(all_of(unchosen), "");
  EXPECT_THAT(unchosen.trouble(), HasSubstr("several lines: 10.1.1.1:50312, 10.2.2.2:16171; "
                                            "--interface chooses one"));
  LineFile device(file("tcp.pcap"), false, "10.2.2.2:16171");
  EXPECT_EQ(all_of(device), "$GPHDT,75.5664,T*36\r\n$GNTHS,244.17,A*1D\r\n");
}

/// A file of fixtures/capture/network, each of whose packets `change` may change.
std::string changed(const std::string& name, const std::function<void(Buffer& packet)>& change) {
  const Buffer plain = wire::testing::fixture("capture/network/" + name);
  Buffer out(plain.begin(), plain.begin() + 24);
  for (std::size_t at = 24; at < plain.size();) {
    const std::size_t size = 16 + wire::load_le<std::uint32_t>(plain, at + 8);
    Buffer packet(plain.begin() + at, plain.begin() + at + size);
    change(packet);
    out = out + packet;
    at += size;
  }
  const auto path = std::filesystem::temp_directory_path() / ("changed-" + name);
  std::ofstream(path, std::ios::binary) << wire::testing::as_text(out);
  return path.string();
}

TEST(NetworkLines, PiecesOfADatagramAreCountedAndNotRead) {
  LineFile line(changed("udp-ethernet.pcap",
                        [](Buffer& packet) {
                          constexpr std::size_t flags = 16 + 14 + 6;  // RFC 791, behind Ethernet
                          if (wire::testing::as_text(packet).find("HDT") != std::string::npos)
                            packet[flags] = 0x20;  // more fragments
                        }),
                false);
  EXPECT_EQ(all_of(line), "$GNTHS,244.17,A*1D\r\n");
  EXPECT_EQ(line.damage(), "1 fragments of IP packets passed over");
  EXPECT_EQ(line.damage("10.1.1.11:50000"), "");  // of another sender
}

TEST(NetworkLines, PacketsThatAreCutShortAreCounted) {
  LineFile line(changed("udp-ethernet.pcap",
                        [](Buffer& packet) {  // as a snap length of 48 bytes leaves it
                          if (packet.size() <= 16 + 48) return;
                          packet.resize(16 + 48);
                          wire::store_le<std::uint32_t>(packet, 8, 48);
                        }),
                false);
  while (line.next()) continue;
  EXPECT_EQ(line.damage(),
            "2 packets are cut short, so their ends are not in the file: record whole ones "
            "(tcpdump -s 0)");
}

TEST(NetworkLines, WhatIsMissingInAStreamIsSaid) {
  const auto later_by_100 = [](Buffer& packet) {
    constexpr std::size_t sequence = 16 + 14 + 20 + 4;  // RFC 9293, behind Ethernet and IPv4
    if (wire::testing::as_text(packet).find(".5664") != std::string::npos)
      wire::store_be<std::uint32_t>(packet, sequence,
                                    wire::load_be<std::uint32_t>(packet, sequence) + 100);
  };
  LineFile line(changed("tcp.pcap", later_by_100), false, "10.2.2.2:16171");
  EXPECT_EQ(all_of(line), "$GPHDT,75.5664,T*36\r\n$GNTHS,244.17,A*1D\r\n");
  EXPECT_EQ(line.damage(), "100 bytes of TCP are not in the file");
}

TEST(StreamOrder, GivesEachByteOnceAndInOrder) {
  StreamOrder order;
  std::string got;
  const auto take = [&](std::uint32_t sequence, std::string_view text) {
    order.take(sequence, as_bytes(text));
    got += wire::testing::as_text(order.ready());
  };
  order.begin(0xFFFFFFFD);  // the numbers wrap
  take(0xFFFFFFFE, "ab");
  take(2, "ef");           // too early
  take(0xFFFFFFFE, "ab");  // again
  take(0xFFFFFFFF, "bcd");
  take(4, "g");
  EXPECT_EQ(got, "abcdefg");
  EXPECT_EQ(order.lost_bytes(), 0u);
}

TEST(StreamOrder, GoesOnOverAGapAtTheEnd) {
  StreamOrder order;
  order.take(100, as_bytes("ab"));
  order.take(110, as_bytes("cd"));
  EXPECT_EQ(wire::testing::as_text(order.ready()), "ab");
  order.finish();
  EXPECT_EQ(wire::testing::as_text(order.ready()), "cd");
  EXPECT_EQ(order.lost_bytes(), 8u);
}

}  // namespace network_test
}  // namespace drydock::capture::testing
