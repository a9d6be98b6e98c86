// Bytes of a line that other programs wrote down in their own form.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "drivers/capture/byte_content.hpp"
#include "drivers/capture/line_file.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {
namespace dumped_bytes_test {

using ::testing::HasSubstr;

/// Read in blocks of a few bytes behind the first one.
std::string content(std::string_view text, std::string* note = nullptr) {
  ByteContent read(false);
  const wire::Bytes bytes{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
  const std::size_t first = std::min<std::size_t>(bytes.size(), 200);
  std::string out{wire::as_text(read.of(bytes.first(first)))};
  for (std::size_t at = first; at < bytes.size(); at += 7)
    out += wire::as_text(read.of(bytes.subspan(at, std::min<std::size_t>(7, bytes.size() - at))));
  out += wire::as_text(read.finish());
  if (note != nullptr) *note = read.note();
  return out;
}

constexpr std::string_view objects =
    "{\"time\":1.5,\"a\":\"x, {y} \\\" z\",\"b\":[{\"id\":0},{\"id\":1}]}\n{\"time\":2}\n";

TEST(DumpedBytes, OfJsonInAListAreAnObjectALine) {
  std::string note;
  EXPECT_EQ(
      content("[{\"time\": 1.5, \"a\": \"x, {y} \\\" z\", \"b\": [{\"id\": 0}, {\"id\": 1}]}, "
              "{\"time\": 2}]\n",
              &note),
      objects);
  EXPECT_THAT(note, HasSubstr("JSON in a list or over several lines"));
}

TEST(DumpedBytes, OfJsonOverSeveralLinesAreAnObjectALine) {
  for (const char* text :
       {"{\n  \"time\": 1.5,\n  \"a\": \"x, {y} \\\" z\",\n  \"b\": [\n    {\n      \"id\": 0\n    "
        "},\n    {\n      \"id\": 1\n    }\n  ]\n}\n{\n  \"time\": 2\n}\n",
        "[\r\n  {\r\n    \"time\": 1.5,\r\n    \"a\": \"x, {y} \\\" z\",\r\n    \"b\": "
        "[{\"id\":0},{\"id\":1}]\r\n  },\r\n  {\r\n    \"time\": 2\r\n  }\r\n]\r\n"})
    EXPECT_EQ(content(text), objects) << text;
}

TEST(DumpedBytes, OfATornObjectDoNotTakeTheNextWithThem) {
  EXPECT_EQ(content("{\n \"time\": 1,\n \"vx\": 0.1\n{\n \"time\": 2\n}\n"),
            "{\"time\":1,\"vx\":0.1\n{\"time\":2}\n");
}

TEST(DumpedBytes, OfADevicesOwnLinesStayAsTheyAre) {
  constexpr std::string_view lines = "{\"time\": 1, \"a\": [1, 2]}\r\n{\"time\": 2}\r\n";
  EXPECT_EQ(content(lines), lines);
}

/// Each `*` of these thirty asks for 16 MB; one block has room for the first.
TEST(DumpedBytes, OfRepeatsWithoutMeasureAreDamage) {
  std::string text = "00000000: 4142 4344 4546 4748  ABCDEFGH\n";
  for (int i = 1; i <= 30; ++i)
    text += fmt::format("*\n{:08x}: 4142 4344 4546 4748  ABCDEFGH\n", i * 0xFFFFF0);
  HexDump dump;
  EXPECT_LT(dump.of({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}).size(),
            17'000'000U);
  EXPECT_EQ(dump.odd_lines(), 29U);
}

TEST(DumpedBytes, OfALineWithoutEndAreNotKept) {
  const std::string eight = "4142 4344 4546 4748\n";
  const std::string text = "00000000: " + eight + "00000008: " + eight + "00000010: 4142 " +
                           std::string(100'000, '4') + "\n";
  std::string note;
  EXPECT_EQ(content(text, &note).size(), 16U);
  EXPECT_THAT(note, HasSubstr("left out: 1"));
}

// `printf '$PRDID,-0.5,1.2,359.9*5F\r\nABC' | xxd`, `| hexdump -C`, `| od -t x1`.
constexpr std::string_view dumped = "$PRDID,-0.5,1.2,359.9*5F\r\nABC";

TEST(DumpedBytes, OfXxdHexdumpAndOdAreThoseOfTheLine) {
  for (const char* text :
       {"00000000: 2450 5244 4944 2c2d 302e 352c 312e 322c  $PRDID,-0.5,1.2,\n"
        "00000010: 3335 392e 392a 3546 0d0a 4142 43         359.9*5F..ABC\n",
        "00000000  24 50 52 44 49 44 2c 2d  30 2e 35 2c 31 2e 32 2c  |$PRDID,-0.5,1.2,|\n"
        "00000010  33 35 39 2e 39 2a 35 46  0d 0a 41 42 43           |359.9*5F..ABC|\n0000001d\n",
        "0000000 24 50 52 44 49 44 2c 2d 30 2e 35 2c 31 2e 32 2c\n"
        "0000020 33 35 39 2e 39 2a 35 46 0d 0a 41 42 43"}) {
    std::string note;
    EXPECT_EQ(content(text, &note), dumped) << text;
    EXPECT_EQ(note, "a hexadecimal dump, read as the bytes that it means");
  }
}

// `printf 'a|b  |c|defghijklm|' | xxd`
TEST(DumpedBytes, OfXxdMayHaveBarsAmongTheLetters) {
  EXPECT_EQ(content("00000000: 617c 6220 207c 637c 6465 6667 6869 6a6b  a|b  |c|defghijk\n"
                    "00000010: 6c6d 7c                                  lm|\n"),
            "a|b  |c|defghijklm|");
}

// The first bytes of a PD0 ensemble in words.
TEST(DumpedBytes, OfWordsMayBeginAsAnEnsembleInDigits) {
  EXPECT_EQ(content("0000000 7f7f 01ae 0600 0012 004d 008e 0110 0192\n0000010 5251\n").substr(0, 6),
            std::string("\x7f\x7f\xae\x01\0\6", 6));
}

TEST(DumpedBytes, OfPairsOfDigitsWithBlanksAreThoseOfTheLine) {
  EXPECT_EQ(
      content("24 50 52 44 49 44 2C 2D 30 2E 35 2C 31 2E 32 2C\r\n33 35 39 2E 39 2A 35 46 0D 0A "
              "41 42 43\r\n"),
      dumped);
  constexpr std::string_view numbers = "10 20 30 40 50 60 70 80 90 11 22 33 44 55 66 77 88\n";
  EXPECT_EQ(content(numbers), numbers) << "no letter";
}

// `printf 'ABCDEFGHIJKLMNOPQR' | hexdump`: words of a computer whose low byte is first.
TEST(DumpedBytes, OfWordsAreInTheOrderOfTheFile) {
  EXPECT_EQ(content("0000000 4241 4443 4645 4847 4a49 4c4b 4e4d 504f\n0000010 5251\n0000012\n"),
            "ABCDEFGHIJKLMNOPQR");
}

// `head -c 64 /dev/zero | hexdump -C`, with an A behind.
TEST(DumpedBytes, ThatRepeatAreAllThere) {
  const auto bytes = content(
      "00000000  00 00 00 00 00 00 00 00  00 00 00 00 00 00 00 00  |................|\n"
      "*\n"
      "00000040  41                                                |A|\n00000041\n");
  EXPECT_EQ(bytes, std::string(64, '\0') + "A");
}

TEST(DumpedBytes, WithLinesOfAnotherFormAreSaid) {
  std::string note;
  content("0000: 41 42\nremark\n0002: 43 44\n", &note);
  EXPECT_EQ(note, "") << "the second line is no dump, so this is none";
  EXPECT_EQ(content("0000: 41 42\n0002: 43 44\nremark\n", &note), "ABCD");
  EXPECT_THAT(note, HasSubstr("lines of another form are left out: 1"));
}

TEST(DumpedBytes, OfAFileStayAtItsEnd) {
  const auto path = ::testing::TempDir() + "dumped-bytes-" + std::to_string(::getpid());
  std::ofstream(path) << dumped;
  LineFile file(path, false);
  EXPECT_EQ(wire::as_text(file.next().value().bytes), dumped);
  EXPECT_FALSE(file.next());
  EXPECT_FALSE(file.next());
  std::remove(path.c_str());
}

}  // namespace dumped_bytes_test
}  // namespace drydock::capture
