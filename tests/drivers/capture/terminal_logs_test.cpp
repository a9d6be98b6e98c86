// Logs of terminal programs: what stands around the lines, in which letters, and whose times.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "drivers/capture/byte_content.hpp"
#include "tests/drivers/capture/captures.hpp"

namespace drydock::capture::testing {
namespace terminal_logs_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using wire::testing::as_bytes;
using wire::testing::as_text;

constexpr std::string_view hdt = "$GPHDT,75.5664,T*36", ths = "$GNTHS,244.17,A*1D";  // of manuals

struct Content {
  std::string text, note;
  std::vector<long> ms;  ///< from the first line with a time to each
  std::chrono::nanoseconds first{0};
};

Content content_of(const std::string& log) {
  ByteContent content(false);
  Content out;
  out.text = as_text(content.of(as_bytes(log)));
  for (const auto& line : content.times()) {
    if (out.ms.empty()) out.first = line.time;
    out.ms.push_back(static_cast<long>((line.time - out.first).count() / 1'000'000));
  }
  out.text += as_text(content.finish());
  out.note = content.note();
  return out;
}

std::string lines(const std::vector<std::string>& fronts, const std::string& behind = "") {
  std::string text;
  for (const auto& front : fronts) text += front + std::string(hdt) + behind + "\r\n";
  return text;
}

std::string bare(std::size_t count) { return lines(std::vector<std::string>(count)); }

TEST(TerminalLog, OfPuttyHasALineAboveIt) {
  EXPECT_EQ(
      content_of(
          "=~=~=~=~=~=~=~=~=~=~=~= PuTTY log 2024.05.01 12:00:00 =~=~=~=~=~=~=~=~=~=~=~=\r\n" +
          bare(3))
          .text,
      bare(3));
}

// date -u -d "2024-05-01 12:00:00" +%s
constexpr std::chrono::seconds noon{1714564800};

TEST(TerminalLog, OfManyProgramsHasTheTimeInFrontOfEachLine) {
  const std::vector<std::vector<std::string>> programs{
      {"[2024-05-01 12:00:00.000] ", "[2024-05-01 12:00:00.250] ", "[2024-05-01 12:00:01.000] "},
      {"[Wed May 01 12:00:00.000 2024] ", "[Wed May 01 12:00:00.250 2024] ",
       "[Wed May 01 12:00:01.000 2024] "},                        // Tera Term
      {"1714564800.000 ", "1714564800.250 ", "1714564801.000 "},  // RealTerm, ts %.s
      {"2024-05-01 12:00:00.000 ", "2024-05-01 12:00:00.250 ", "2024-05-01 12:00:01.000 "},
      {"2024-05-01T12:00:00.000000 ", "2024-05-01T12:00:00.250000 ",
       "2024-05-01T12:00:01.000000 "}};  // ts %FT%.T
  for (const auto& fronts : programs) {
    const auto content = content_of(lines(fronts));
    EXPECT_EQ(content.text, bare(3)) << fronts[0];
    EXPECT_THAT(content.ms, ElementsAre(0, 250, 1000)) << fronts[0];
    EXPECT_EQ(content.first, noon) << fronts[0];
  }
}

TEST(TerminalLog, WithoutADateCountsFromMidnightOrTheStartOfTheLog) {
  for (const std::vector<std::string>& fronts : std::vector<std::vector<std::string>>{
           {"12:00:00.000 -> ", "12:00:00.250 -> ", "12:00:01.000 -> "},  // Arduino
           {"[0 00:00:01.000] ", "[0 00:00:01.250] ",
            "[0 00:00:02.000] "}}) {  // Tera Term, elapsed
    const auto content = content_of(lines(fronts));
    EXPECT_EQ(content.text, bare(3)) << fronts[0];
    EXPECT_THAT(content.ms, ElementsAre(0, 250, 1000)) << fronts[0];
  }
}

/// Docklight shows control characters by their names.
TEST(TerminalLog, OfDocklightHasMarksBehindTheLinesAndWhatWasSent) {
  const std::string sent = "01.05.2024 12:00:00.10 [TX] - " + std::string(ths) + "<CR><LF>\r\n";
  const auto content = content_of(
      lines({"01.05.2024 12:00:00.00 [RX] - "}, "<CR><LF>") + sent +
      lines({"01.05.2024 12:00:00.25 [RX] - ", "01.05.2024 12:00:01.00 [RX] - "}, "<CR><LF>"));
  EXPECT_EQ(content.text, bare(1) + "\r\n" + bare(2));
  EXPECT_EQ(content.first, noon);
  EXPECT_THAT(content.note, HasSubstr("what the computer sent ([TX]) is left out: 1 lines"));
}

std::string pairs_of(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) text += fmt::format("{:02X} ", static_cast<unsigned char>(c));
  text.pop_back();
  return text;
}

TEST(TerminalLog, OfDocklightInHexadecimalIsTheBytesAtTheirTimes) {
  std::string log;
  for (const char* time : {"12:00:00.00", "12:00:00.25", "12:00:01.00"})
    log += "01.05.2024 " + std::string(time) + " [RX] - " + pairs_of(std::string(hdt) + "\r\n") +
           "\r\n01.05.2024 " + time + " [TX] - 24 00\r\n";
  const auto content = content_of(log);
  EXPECT_EQ(content.text, bare(3));
  EXPECT_THAT(content.ms, ElementsAre(0, 250, 1000));
  EXPECT_EQ(content.first, noon);
  EXPECT_THAT(content.note, HasSubstr("hexadecimal text behind a logger's times"));
  EXPECT_THAT(content.note, HasSubstr("([TX]) is left out: 3 lines"));
  constexpr std::string_view numbers =
      "12:00:00 10 20 30 40 50 60\n12:00:01 10 20 30 40 50 60\n12:00:02 10 20 30 40 50 60\n";
  EXPECT_EQ(content_of(std::string(numbers)).text, numbers) << "no letter";
}

/// `ts -i` of moreutils prints the time since the line before.
TEST(TerminalLog, OfPausesIsSummedUpAndSaid) {
  std::vector<std::string> fronts;
  for (int i = 0; i < 9; ++i)
    fronts.push_back(i % 2 == 0 ? "00:00:00.250000 " : "00:00:00.200000 ");
  const auto content = content_of(lines(fronts));
  EXPECT_EQ(content.text, bare(9));
  EXPECT_THAT(content.ms, ElementsAre(0, 200, 450, 650, 900, 1100, 1350, 1550, 1800));
  EXPECT_THAT(content.note, HasSubstr("are the pauses between them, summed up here"));
}

TEST(TerminalLog, MayHaveItsTimesOnLinesOfTheirOwn) {
  const auto content =
      content_of("2024-05-01 12:00:00.000\r\n" + bare(2) + "2024-05-01 12:00:00.250\r\n" + bare(2));
  EXPECT_EQ(content.text, "\r\n" + bare(2) + "\r\n" + bare(2));
  EXPECT_THAT(content.ms, ElementsAre(0, 0, 0, 250, 250, 250));
  EXPECT_EQ(content.first, noon);
  EXPECT_THAT(content.note, HasSubstr("times on 2 lines of their own"));
}

/// Half of these sentences were cut or damaged on the line, and the logger has words of its own.
TEST(TerminalLog, OfDamagedSentencesHasItsTimesToo) {
  const std::string text =
      "2024-05-01 12:00:00.000 $GPHDT,75.5664,T*36\r\n2024-05-01 12:00:00.250 $GPHDT,75.56\r\n"
      "2024-05-01 12:00:00.500 link lost\r\n2024-05-01 12:00:00.600 $GPHDT,75.5665,T*36\r\n"
      "2024-05-01 12:00:00.750 $GPH\r\n2024-05-01 12:00:01.000 $GPHDT,75.5664,T*36\r\n";
  const auto content = content_of(text);
  EXPECT_THAT(content.text, HasSubstr("\n$GPHDT,75.5664,T*36\r\n"));
  EXPECT_THAT(content.text, HasSubstr("\n$GPHDT,75.56\r\n"));
  EXPECT_EQ(content.ms.back(), 1000);
  EXPECT_EQ(content.first, noon);
}

std::string utf16(std::string_view text, bool big_endian) {
  std::string out = big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : text) out += big_endian ? std::string{'\0', c} : std::string{c, '\0'};
  return out;
}

TEST(Utf16, OfATextIsReadAsLettersOfEightBits) {
  for (const bool big_endian : {false, true})
    EXPECT_EQ(content_of(utf16(bare(3), big_endian)).text, bare(3)) << big_endian;
  const Outcome frames = read_capture(utf16("(1.5) can0 123#1122\r\n", false));
  ASSERT_EQ(frames.records.size(), 1u);
  EXPECT_THAT(data_of(frames.records[0]), ElementsAre(0x11, 0x22));
}

/// RFC 2781, 4.2: U+10A68 is D802 DE68; in UTF-8 it is F0 90 A9 A8.
TEST(Utf16, PairsOfHalvesAreOneLetterInWhateverPiecesTheyCome) {
  const std::string text =
      utf16("$GPTXT", false) + "\x02\xD8\x68\xDE" + std::string("A\0\x02\xD8", 4);
  Utf16Text utf;
  std::string out;
  for (const char c : text) out += as_text(utf.of(as_bytes(std::string_view(&c, 1))));
  EXPECT_EQ(out,
            "$GPTXT\xF0\x90\xA9\xA8"
            "A");
  EXPECT_FALSE(Utf16Text::recognises(as_bytes(std::string_view("\xFF\xFE\x7F\x7F\x12\x34", 6))));
}

/// What `tshark -q -z follow,udp,hex,0` (4.0.17) prints of fixtures/capture/network, and of a
/// stream whose first segment has nine bytes.
TEST(Dump, OfAStreamInWiresharkHasAGapInTheMiddleOfItsLines) {
  EXPECT_EQ(
      content_of("===================================================================\n"
                 "Follow: udp,hex\nFilter: udp.stream eq 0\nNode 0: 10.1.1.1:50000\n"
                 "Node 1: 10.2.2.2:27000\n"
                 "00000000  24 47 50 48 44 54 2c 37  35 2e 35 36 36 34 2c 54  $GPHDT,7 5.5664,T\n"
                 "00000010  2a 33 36 0d 0a                                    *36..\n"
                 "00000015  24 47 4e 54 48 53 2c 32  34 34 2e 31 37 2c 41 2a  $GNTHS,2 44.17,A*\n"
                 "00000025  31 44 0d 0a                                       1D..\n")
          .text,
      std::string(hdt) + "\r\n" + std::string(ths) + "\r\n");
  const auto both = content_of(
      "00000000  24 47 50 48 44 54 2c 37  35                       $GPHDT,7 5\n"
      "00000009  2e 35 36 36 34 2c 54 2a  33 36 0d 0a 24 47 4e 54  .5664,T* 36..$GNT\n"
      "\t00000000  7b 22 63 6f 6d 6d 61 6e  64 22 3a 22 67 65 74 5f  {\"comman d\":\"get_\n"
      "00000019  48 53 2c 32 34 34 2e 31  37 2c 41 2a 31 44 0d 0a  HS,244.1 7,A*1D..\n");
  EXPECT_EQ(both.text, std::string(hdt) + "\r\n" + std::string(ths) + "\r\n");
  EXPECT_THAT(both.note, HasSubstr("of the other side, are left out: 1"));
}

/// Letters behind two blanks may look like digits.
TEST(Dump, OfEightBytesALineEndsAtItsLetters) {
  EXPECT_EQ(content_of("00000000  61 62 20 63 64 20 65 66  ab cd ef\n"
                       "00000008  61 62 20 63 64 20 65 66  ab cd ef\n")
                .text,
            "ab cd efab cd ef");
}

}  // namespace terminal_logs_test
}  // namespace drydock::capture::testing
