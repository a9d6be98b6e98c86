#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>

#include "drivers/capture/line_file.hpp"
#include "drivers/wire/bytes.hpp"
#include "tests/drivers/capture/captures.hpp"

/// Packets that tcpdump and tshark printed, against the file of packets that they printed.
namespace drydock::capture::testing {
namespace packet_text_test {

using ::testing::HasSubstr;
using namespace std::chrono_literals;

class TextFile {
 public:
  explicit TextFile(std::string_view text) {
    const int fd = mkstemp(path_.data());
    if (::write(fd, text.data(), text.size()) != static_cast<ssize_t>(text.size())) std::abort();
    ::close(fd);
  }
  ~TextFile() { ::unlink(path_.c_str()); }
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_ = "/tmp/drydock_packets_XXXXXX";
};

const std::string tcp = DRYDOCK_SOURCE_DIR "/fixtures/capture/network/tcp.pcap";

struct Heard {
  std::string text;
  std::vector<std::chrono::nanoseconds> times;
};

Heard hear(LineFile& line) {
  Heard heard;
  while (const auto read = line.next()) {
    heard.text += wire::testing::as_text(read->bytes);
    if (read->time) heard.times.push_back(*read->time);
  }
  EXPECT_EQ(line.trouble(), "");
  return heard;
}

/// `tcpdump -tttt -X` prints a packet behind its link's header, `-XX` with it.
std::string printed(std::size_t link_header) {
  const Buffer file = wire::testing::fixture("capture/network/tcp.pcap");
  std::string text;
  for (std::size_t at = 24; at < file.size();) {
    const std::size_t size = wire::load_le<std::uint32_t>(file, at + 8);
    // date -u -d @1795636569: 2026-11-25 19:56:09, the second of all packets of the fixture
    EXPECT_EQ(wire::load_le<std::uint32_t>(file, at), 1795636569u);
    text += fmt::format("2026-11-25 19:56:09.{:06} IP 10.2.2.2.16171 > 10.1.1.1.50312: tcp\n",
                        wire::load_le<std::uint32_t>(file, at + 4));
    const Bytes packet = Bytes{file}.subspan(at + 16 + link_header, size - link_header);
    for (std::size_t place = 0; place < packet.size(); place += 16) {
      std::string digits, letters;
      for (std::size_t i = place; i < std::min(place + 16, packet.size()); ++i) {
        digits += fmt::format("{:02x}{}", packet[i], i % 2 == 1 ? " " : "");
        letters += packet[i] >= 0x20 && packet[i] < 0x7F ? static_cast<char>(packet[i]) : '.';
      }
      text += fmt::format("\t0x{:04x}:  {:<39}  {}\n", place, digits.substr(0, 39), letters);
    }
    at += 16 + size;
  }
  return text;
}

TEST(PacketText, OfTcpdumpGivesTheLineAndTimesOfItsPackets) {
  constexpr std::size_t ethernet_header = 14;
  LineFile file(tcp, false, "10.2.2.2:16171");
  const Heard expected = hear(file);
  EXPECT_EQ(expected.text, "$GPHDT,75.5664,T*36\r\n$GNTHS,244.17,A*1D\r\n");
  for (const std::size_t link_header : {ethernet_header, std::size_t{0}}) {
    const TextFile text(printed(link_header));
    EXPECT_TRUE(has_packets(text.path()));
    LineFile line(text.path(), false, "10.2.2.2:16171");
    const Heard heard = hear(line);
    EXPECT_EQ(heard.text, expected.text) << link_header;
    EXPECT_EQ(heard.times, expected.times) << link_header;
    EXPECT_THAT(line.note(), HasSubstr("as tcpdump or tshark printed them"));
  }
}

/// `tshark -t ad -Px -r udp-ethernet.pcap` (4.0.17).
TEST(PacketText, OfTsharkHasItsTimeAboveABlankLine) {
  const TextFile text(
      "    1 2026-11-25 19:56:07.000001     10.1.1.1 → 10.2.2.2     UDP 63 50000 → 27000 Len=21\n"
      "\n"
      "0000  20 52 45 43 56 00 20 53 45 4e 44 00 08 00 45 00    RECV. SEND...E.\n"
      "0010  00 31 12 34 00 00 ff 11 92 82 0a 01 01 01 0a 02   .1.4............\n"
      "0020  02 02 c3 50 69 78 00 1d 9f 9d 24 47 50 48 44 54   ...Pix....$GPHDT\n"
      "0030  2c 37 35 2e 35 36 36 34 2c 54 2a 33 36 0d 0a      ,75.5664,T*36..\n"
      "\n");
  LineFile line(text.path(), false);
  const Heard heard = hear(line);
  EXPECT_EQ(heard.text, "$GPHDT,75.5664,T*36\r\n");
  ASSERT_EQ(heard.times.size(), 1u);
  EXPECT_EQ(heard.times[0], 1795636567s + 1us);
  EXPECT_EQ(line.lines()[0].name, "10.1.1.1:50000");
}

/// A dump of a line's bytes has places that begin at 0 too.
TEST(PacketText, IsNoDumpOfALine) {
  const TextFile text(
      "00000000: 2450 5244 4944 2c2d 302e 352c 312e 322c  $PRDID,-0.5,1.2,\n"
      "00000010: 3335 392e 392a 3546 0d0a                 359.9*5F..\n");
  EXPECT_FALSE(has_packets(text.path()));
  LineFile line(text.path(), false);
  EXPECT_EQ(hear(line).text, "$PRDID,-0.5,1.2,359.9*5F\r\n");
}

}  // namespace packet_text_test
}  // namespace drydock::capture::testing
