#include "drivers/capture/sentence_stamps.hpp"

#include <gtest/gtest.h>

#include "drivers/capture/byte_content.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

/// What loggers write around the sentences of NMEA 0183.
namespace drydock::capture::testing {
namespace sentence_stamps_test {

using wire::testing::as_bytes;
using wire::testing::as_text;

constexpr std::string_view hdt = "$GPHDT,75.5664,T*36", ths = "$GNTHS,244.17,A*1D";  // of manuals

std::string four_lines(const std::string& before, const std::string& behind) {
  std::string text;
  for (const auto sentence : {hdt, ths, hdt, ths})
    text += before + std::string(sentence) + behind + "\r\n";
  return text;
}

std::string without(const std::string& text) {
  SentenceStamps stamps;
  return std::string(as_text(stamps.without(as_bytes(text))));
}

TEST(SentenceStamps, OfKnownLoggersAreLeftOut) {
  const std::string plain = four_lines("", "");
  for (const std::string stamp :
       {"2023-12-31T23:59:30.100000Z ", "1704067170.100000 ", "[2023-12-31T23:59:30.100] ",
        "23:59:30.100 (TCP:1.2.3.4:10110 <RX>) : ", "1704067170100;N;"})
    EXPECT_EQ(without(four_lines(stamp, "")), plain) << stamp;
  EXPECT_EQ(without(four_lines("\"AP\",\"RX\",2023-12-31T23:59:30.100Z,\"NMEA0183\",\"", "\"")),
            plain);
}

TEST(SentenceStamps, AreLookedForInWhateverPiecesTheLinesCome) {
  const std::string text = four_lines("12:00:00 ", "");
  SentenceStamps stamps;
  std::string out(as_text(stamps.without(as_bytes(text.substr(0, 100)))));
  for (std::size_t at = 100; at < text.size(); at += 7)
    out += as_text(stamps.without(as_bytes(text.substr(at, 7))));
  EXPECT_EQ(out, four_lines("", ""));
  EXPECT_EQ(stamps.lines(), 4u);
}

TEST(SentenceStamps, AreNoTagBlocksAndNoNoiseInFrontOfFew) {
  for (const std::string& text :
       {four_lines("", ""), four_lines("\\s:GPS1,c:1704067170*4C\\", ""),
        four_lines("", "") + "noise" + std::string(hdt) + "\r\n", std::string("boot\r\n") + "x\n"})
    EXPECT_EQ(without(text), text);
}

/// As openrvdas stores UHDAS: a sentence without a checksum shows itself by its name behind a time.
TEST(SentenceStamps, OfSentencesWithoutAChecksumAreLeftOutToo) {
  const auto lines_behind = [](const std::string& stamp) {
    std::string text;
    for (const char* value : {"4.87", "4.77", "4.73", "4.83"})
      text += stamp + "$PUHAW,UVH,-" + value + ",-6.04,219.2\n";
    return text;
  };
  EXPECT_EQ(without(lines_behind("2014-08-01T00:00:00.186000Z ")), lines_behind(""));
  EXPECT_EQ(without(lines_behind("offset ")), lines_behind("offset ")) << "no time";
}

TEST(SentenceStamps, StayWhereALineHasNoSentence) {
  std::string text;
  for (int i = 0; i < 4; ++i) text += four_lines("12:00:00 ", "");
  EXPECT_NE(without(text + "12:00:01 link lost\r\n").find("12:00:01 link lost"), std::string::npos);
}

/// Milliseconds from the first line to each that has a time.
std::vector<long> times_in(const std::string& text) {
  SentenceStamps stamps;
  stamps.without(as_bytes(text));
  std::vector<long> times;
  for (const auto& line : stamps.times())
    times.push_back(
        static_cast<long>((line.time - stamps.times().front().time).count() / 1'000'000));
  return times;
}

std::string lines(std::initializer_list<const char*> fronts) {
  std::string text;
  for (const std::string front : fronts) text += front + std::string(hdt) + "\r\n";
  return text;
}

TEST(SentenceStamps, AreTheTimesOfTheirLines) {
  EXPECT_EQ(times_in(lines({"23:59:59.900 ", "23:59:59.950 ", "00:00:00.100 "})),
            (std::vector<long>{0, 50, 200}))
      << "over midnight";
  EXPECT_EQ(times_in(lines({"COM3 1704067170.100 ", "COM3 1704067171.350 ", "COM3 ", "COM3 "})),
            (std::vector<long>{0, 1250, 1250, 1250}))
      << "a line without a time has that of the one before";
}

/// NMEA 0183 4.00: the first sentence of a group alone has the time.
TEST(SentenceStamps, OfTagBlocksAreTimesAndStayInTheirSentences) {
  const std::string text = lines(
      {"\\g:1-2-73,s:r1,c:1704067170100*4C\\", "\\g:2-2-73*11\\", "\\s:r1,c:1704067171*4C\\", ""});
  EXPECT_EQ(without(text), text);
  EXPECT_EQ(times_in(text), (std::vector<long>{0, 0, 900, 900}));
}

/// `wrx` lines are of Water Linked's protocol page, with their checksums; those of PD6 are of a
/// DVL's firmware test on GitHub. Neither sends a clock in each line, so the logger's time is all.
TEST(SentenceStamps, AreTimesOfTheTextLinesOfADvlToo) {
  const std::vector<std::vector<std::string>> dvls{
      {"wrx,112.83,0.007,0.017,0.006,0.000,0.93,y,0*d2",
       "wrx,140.43,0.008,0.021,0.012,0.000,0.92,y,0*b7",
       "wrx,118.47,0.009,0.020,0.013,0.000,0.92,y,0*54"},
      {":SA,-5.89,+4.33,0.00", ":BI,-32768,-32768,-32768,-32768,V",
       ":BD,+0.00,+0.00,+0.00,0.00,0.00"},
      {R"({"vx":0.5,"note":"a*b","type":"velocity"})", R"({"vx":0.6,"type":"velocity"})",
       R"({"vx":0.7,"type":"velocity"})"}};
  const std::vector<std::string> stamps{"[2023-05-05 10:11:01.000] ", "[2023-05-05 10:11:01.250] ",
                                        "[2023-05-05 10:11:02.000] "};
  for (const auto& dvl : dvls) {
    std::string logged, said;
    for (std::size_t line = 0; line < dvl.size(); ++line) {
      logged += stamps[line] + dvl[line] + "\r\n";
      said += dvl[line] + "\r\n";
    }
    EXPECT_EQ(without(logged), said);
    EXPECT_EQ(times_in(logged), (std::vector<long>{0, 250, 1000})) << dvl[0];
    EXPECT_EQ(without(said), said);
    ByteContent content(false);
    content.of(as_bytes(logged));
    EXPECT_EQ(content.note(),
              "a logger's stamps around 3 lines are their times (format=raw keeps them)");
  }
}

/// A number in front that is no time may belong to the line.
TEST(SentenceStamps, OfTextLinesAreTimesOrTheyStay) {
  std::string text;
  for (const std::string line : {"1 :SA,1,2,3", "2 :SA,1,2,3", "3 :SA,1,2,3"})
    text += line + "\r\n";
  EXPECT_EQ(without(text), text);
}

/// A logger may write JSON around a sentence: this is what is read.
TEST(SentenceStamps, InJsonAreOfTheSentenceInIt) {
  EXPECT_EQ(without(four_lines(R"({"t":"2023-12-31T23:59:30.100Z","raw":")", "\"")),
            four_lines("", ""));
}

TEST(SentenceStamps, OfACaptureAreTold) {
  const std::string text = four_lines("12:00:00 ", "");
  ByteContent content(false), raw(true);
  content.of(as_bytes(text));
  EXPECT_EQ(content.note(),
            "a logger's stamps around 4 sentences are their times, in whole seconds (format=raw "
            "keeps them)");
  EXPECT_EQ(as_text(raw.of(as_bytes(text))), text);
  EXPECT_EQ(raw.note(), "");
}

}  // namespace sentence_stamps_test
}  // namespace drydock::capture::testing
