// A log of hexadecimal text, as a DVL set to ASCII output (CF) writes it, reads like its bytes.
#include <gmock/gmock.h>

#include <fstream>

#include "drivers/decode/replay.hpp"
#include "tests/drivers/decode/captured.hpp"

namespace drydock::decode {
namespace hex_text_test {

using testing::HasSubstr;

std::string golden() {
  std::ifstream in(DRYDOCK_SOURCE_DIR "/fixtures/pd0/golden.pd0", std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Two digits a byte, `width` bytes a line.
std::string hex_of(const std::string& bytes, std::size_t width, const char* digits) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (i > 0 && i % width == 0) text += "\r\n";
    const auto byte = static_cast<unsigned char>(bytes[i]);
    text += digits[byte >> 4];
    text += digits[byte & 15];
  }
  return text + "\r\n";
}

constexpr const char *upper = "0123456789ABCDEF", *lower = "0123456789abcdef";

TEST(HexText, EnsemblesInHexadecimalDecodeAsTheirBytesDo) {
  const TemporaryFile bytes(golden());
  const Decoded expected = run_decode({"pd0", bytes.path()});
  ASSERT_EQ(expected.lines().size(), 4u);  // NOTE.md of the fixture: the fourth of five has none
  for (const auto& text : {hex_of(golden(), 1'000'000, upper), hex_of(golden(), 37, lower)}) {
    const TemporaryFile file(text);
    const Decoded decoded = run_decode({"pd0", file.path()});
    EXPECT_EQ(decoded.out, expected.out);
    EXPECT_THAT(decoded.err, HasSubstr("hexadecimal text"));
  }
}

TEST(HexText, ReplayReadsItToo) {
  const TemporaryFile bytes(golden()), text(hex_of(golden(), 50, upper));
  ReplayOptions options;
  options.protocol = "pd0";
  std::vector<std::string> outputs;
  for (const auto* file : {&bytes, &text}) {
    options.capture = file->path();
    MemoryFile out, err;
    EXPECT_EQ(replay(options, out.file(), err.file()), 0);
    outputs.push_back(out.text());
  }
  EXPECT_FALSE(outputs[0].empty());
  EXPECT_EQ(outputs[1], outputs[0]);
}

/// A digit is lost in the first line: its ensemble is damaged, the others are not.
TEST(HexText, ALostDigitCostsOneEnsemble) {
  std::string text = hex_of(golden(), 16, upper);
  text.erase(40, 1);
  const TemporaryFile file(text);
  EXPECT_EQ(run_decode({"pd0", file.path()}).lines().size(), 3u);
}

TEST(HexText, ARawFormatReadsTheDigitsThemselves) {
  const TemporaryFile file(hex_of(golden(), 16, upper));
  DecodeOptions options{"pd0", file.path()};
  options.format = "raw";
  EXPECT_EQ(run_decode(options).exit_code, 1);
}

}  // namespace hex_text_test
}  // namespace drydock::decode
