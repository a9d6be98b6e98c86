// Files into which a logger cut one capture are read like that capture.
#include <gmock/gmock.h>

#include <list>

#include "tests/drivers/decode/captured.hpp"

namespace drydock::decode {
namespace series_test {

using testing::HasSubstr;

// The example for GGA on the gpsd project's page on NMEA sentences.
constexpr std::string_view gga =
    "$GPGGA,123519,4807.038,N,01131.324,E,1,08,0.9,545.4,M,46.9,M,,*42\r\n";

std::string fixture(const std::string& name) {
  return read_file(DRYDOCK_SOURCE_DIR "/fixtures/" + name);
}

Decoded decode_series(DecodeOptions options, const std::vector<std::string>& parts) {
  std::list<TemporaryFile> files;
  for (const auto& part : parts) files.emplace_back(part);
  options.file = files.front().path();
  for (auto file = std::next(files.begin()); file != files.end(); ++file)
    options.more.push_back(file->path());
  return run_decode(options);
}

Decoded decode_series(const std::string& protocol, const std::vector<std::string>& parts) {
  DecodeOptions options;
  options.protocol = protocol;
  return decode_series(options, parts);
}

/// In three parts; the middle one is short.
std::vector<std::string> cut(const std::string& whole, std::size_t at) {
  return {whole.substr(0, at), whole.substr(at, 3), whole.substr(at + 3)};
}

TEST(Series, AFrameCutAtTheEdgeOfTwoFilesIsRead) {
  const std::string whole = std::string(gga) + std::string(gga);
  for (const std::size_t at : {1u, 30u, 67u, 68u, 100u}) {
    const auto decoded = decode_series("nmea0183", cut(whole, at));
    EXPECT_EQ(decoded.lines().size(), 2u) << at;
    EXPECT_EQ(decoded.err, "2 frames, 2 messages, 0 bad checksums, 0 bytes skipped\n") << at;
  }
}

TEST(Series, EveryCaptureReadsCutLikeWhole) {
  for (const auto& [name, protocol] :
       std::vector<std::pair<std::string, std::string>>{{"pd0/golden.pd0", "pd0"},
                                                        {"capture/frames.log", "can"},
                                                        {"capture/dec.asc", "can"},
                                                        {"capture/v2.1.trc", "can"},
                                                        {"capture/savvycan.csv", "can"},
                                                        {"capture/frames.blf", "can"},
                                                        {"capture/be.pcapng", "can"}}) {
    const auto whole = decode_series(protocol, {fixture(name)});
    ASSERT_GT(whole.lines().size(), 3u) << name;
    const std::size_t size = fixture(name).size();
    for (const std::size_t at : {size / 3, size / 2, size - 40}) {
      const auto decoded = decode_series(protocol, cut(fixture(name), at));
      EXPECT_EQ(decoded.out, whole.out) << name << " at " << at;
      EXPECT_EQ(decoded.err, whole.err) << name << " at " << at;
    }
  }
}

TEST(Series, EachFileWithAHeadOfItsOwnIsReadByIt) {
  for (const auto* name : {"dec.asc", "v2.1.trc", "savvycan.csv", "table.csv", "frames.blf",
                           "le_us.pcap", "be.pcapng", "busmaster.log"}) {
    const std::string file = fixture(std::string("capture/") + name);
    const auto once = decode_series("can", {file});
    const auto twice = decode_series("can", {file, file});
    EXPECT_EQ(twice.out, once.out + once.out) << name;
    EXPECT_THAT(twice.err, testing::Not(HasSubstr("not understood"))) << name;
  }
  const auto mixed = decode_series("can", {fixture("capture/hex.asc"), fixture("capture/dec.asc")});
  EXPECT_EQ(mixed.out, decode_series("can", {fixture("capture/hex.asc")}).out +
                           decode_series("can", {fixture("capture/dec.asc")}).out);
}

TEST(Series, TimesThatBeginAgainGoOnBehindTheLastOnes) {
  const auto decoded = decode_series("can", {" (000.000000)  can0  123   [1]  11\n"
                                             " (005.500000)  can0  123   [1]  22\n",
                                             " (000.250000)  can0  123   [1]  33\n"
                                             " (001.250000)  can0  123   [1]  44\n"});
  const auto lines = decoded.lines();
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[1]["time_s"], 5.5);
  EXPECT_EQ(lines[2]["time_s"], 5.5);
  EXPECT_EQ(lines[3]["time_s"], 6.5);
  EXPECT_THAT(decoded.err, HasSubstr("its times count from its own start"));
}

TEST(Series, InTheWrongOrderIsSaid) {
  const auto decoded = decode_series(
      "can", {"(1700000010.000000) can0 123#11\n", "(1700000000.000000) can0 123#22\n"});
  EXPECT_EQ(decoded.lines()[1]["time_s"], 1700000000.0);
  EXPECT_THAT(decoded.err, HasSubstr("begins 10.000 s before the file in front of it ends"));
}

/// fixtures/capture/network/NOTE: what text2pcap made of two sentences, in segments.
TEST(Series, AStreamOfTcpGoesOnInTheNextFileOfPackets) {
  const std::string whole = fixture("capture/network/tcp.pcap");
  constexpr std::size_t head = 24, packet_head = 16, size_at = 8;
  DecodeOptions options;
  options.protocol = "nmea0183";
  options.interface = "10.2.2.2:16171";
  const auto expected = decode_series(options, {whole});
  ASSERT_EQ(expected.lines().size(), 2u);
  std::size_t cuts = 0;
  for (std::size_t at = head; at < whole.size(); ++cuts) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(whole[at + i]); };
    at += packet_head + byte(size_at) + 256u * byte(size_at + 1);
    const auto decoded =
        decode_series(options, {whole.substr(0, at), whole.substr(0, head) + whole.substr(at)});
    EXPECT_EQ(decoded.out, expected.out) << at;
  }
  EXPECT_GT(cuts, 2u);
}

TEST(Series, AFileOfPacketsThatEndsInOneSaysHowMuchIsLeft) {
  const std::string whole = fixture("capture/network/udp-sll.pcap");
  const auto decoded = decode_series("nmea0183", {whole.substr(0, whole.size() - 5)});
  EXPECT_THAT(decoded.err, HasSubstr(" ends inside of a packet: "));
}

TEST(Series, ATextOfDigitsMayBeCutInAByte) {
  const std::string bytes = fixture("pd0/golden.pd0");
  std::string text;
  for (const char c : bytes) {
    constexpr const char* digits = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(c);
    text += digits[byte >> 4];
    text += digits[byte & 15];
    if (text.size() % 101 == 100) text += "\r\n";
  }
  const auto whole = decode_series("pd0", {text});
  ASSERT_EQ(whole.lines().size(), 4u);
  for (const std::size_t at : {301u, 500u, 777u})
    EXPECT_EQ(decode_series("pd0", cut(text, at)).out, whole.out) << at;
}

TEST(Series, ALoggersLinesMayBeCutAnywhere) {
  std::string text;
  for (int i = 0; i < 20; ++i)
    text += "2023-12-31T23:59:" + std::to_string(10 + i) + ".120Z $GPHDT,75.5664,T*36\r\n";
  for (const std::size_t at : {150u, 160u, 175u, 189u}) {
    const auto decoded = decode_series("nmea0183", cut(text, at));
    EXPECT_EQ(decoded.lines().size(), 20u) << at;
    EXPECT_THAT(decoded.err, HasSubstr("20 frames, 20 messages, 0 bad checksums, 0 bytes skipped"));
  }
}

TEST(Series, OneWithACommentAtItsHeadBeginsAnew) {
  const std::string with_head = "# Name = a receiver\n" + std::string(gga);
  const auto decoded = decode_series("nmea0183", {with_head, with_head});
  EXPECT_EQ(decoded.lines().size(), 2u);
  EXPECT_THAT(decoded.err, HasSubstr(" 0 bytes skipped"));
}

TEST(Series, AFileOfPacketsBehindBytesIsNoneOfTheSeries) {
  const auto decoded =
      decode_series("nmea0183", {std::string(gga), fixture("capture/network/tcp.pcap")});
  EXPECT_EQ(decoded.exit_code, 1);
  EXPECT_THAT(decoded.err, HasSubstr("is a file of packets, and the one before it holds bytes"));
}

}  // namespace series_test
}  // namespace drydock::decode
