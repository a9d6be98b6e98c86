#include "tests/drivers/probe/uart.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <random>
#include <sstream>
#include <string>

/// The model of a serial line beside tests/ports/uart.py, whose own expectations are worked out by
/// hand (tests/ports/uart_test.py).
namespace drydock::probe {
namespace uart_test {

using uart_model::Receiver;
using wire::ByteFrame;
using wire::Parity;

constexpr unsigned baud = 9600;

std::string hex(const std::vector<std::uint8_t>& bytes) {
  std::string text;
  for (const auto byte : bytes) {
    std::array<char, 3> two{};
    std::snprintf(two.data(), two.size(), "%02x", byte);
    text += two.data();
  }
  return text;
}

/// What is read of bytes that follow each other without a pause, then of an idle line.
std::vector<std::uint8_t> read(const std::vector<std::uint8_t>& bytes, ByteFrame sender,
                               ByteFrame receiver) {
  Receiver ear({baud, receiver});
  double now = 0;
  for (const auto byte : bytes)
    for (const auto& level : uart_model::sent(byte, {baud, sender}, now)) {
      ear.hear(level);
      now = level.end_s;
    }
  ear.hear({true, now, now + 12.0 / baud});
  return ear.taken();
}

std::string python(ByteFrame f) {
  constexpr std::array names{"N", "E", "O"};
  return "Frame(" + std::to_string(f.data_bits) + ",'" +
         names.at(static_cast<std::size_t>(f.parity)) + "'," + std::to_string(f.stop_bits) + ")";
}

struct Way {
  ByteFrame sender, receiver;
};

/// What the witness reads of the same bytes each way: lines of hexadecimal digits.
std::vector<std::string> read_by_the_witness(const std::vector<std::uint8_t>& bytes,
                                             const std::vector<Way>& ways) {
  std::string command = "cd '" DRYDOCK_SOURCE_DIR
                        "/tests/ports' && python3 -B -c \"from uart import *\nfor s, r in [";
  for (const auto& way : ways)
    command += "(" + python(way.sender) + ", " + python(way.receiver) + "), ";
  command += "]: print(heard('', ''.join(sent(b, s) for b in bytes.fromhex('" + hex(bytes) +
             "')) + '1' * 12, r)[1].hex())\"";
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::string said;
  std::array<char, 4096> piece{};
  while (std::fgets(piece.data(), piece.size(), pipe) != nullptr) said += piece.data();
  EXPECT_EQ(::pclose(pipe), 0) << command;
  std::istringstream text(said);
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

TEST(Uart, ReadsWhatTheModelOfThePacedLinesReads) {
  const std::array frames{ByteFrame{8, Parity::none, 1}, ByteFrame{8, Parity::even, 1},
                          ByteFrame{8, Parity::odd, 1}, ByteFrame{7, Parity::even, 1},
                          ByteFrame{8, Parity::none, 2}};
  std::vector<Way> ways;
  for (const auto& sender : frames)
    for (const auto& receiver : frames) ways.push_back({sender, receiver});
  std::mt19937 random(1);
  std::vector<std::uint8_t> bytes(300);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
  bytes[100] = bytes[101] = 0;  // with parity, a space as long as a character
  const auto witness = read_by_the_witness(bytes, ways);
  ASSERT_EQ(witness.size(), ways.size());
  for (std::size_t i = 0; i < ways.size(); ++i)
    EXPECT_EQ(hex(read(bytes, ways[i].sender, ways[i].receiver)), witness[i])
        << python(ways[i].sender) << " read by " << python(ways[i].receiver);
}

TEST(Uart, ReadsABreakWhereTheSendersZeroIsLongerThanACharacter) {
  // 0 00000000 1 of 9600 baud is a space of 18 bits of 19200 baud, and so a break: a zero, then
  // nothing before the mark.
  Receiver ear({2 * baud, {}});
  for (const auto& level : uart_model::sent(0, {baud, {}}, 0)) ear.hear(level);
  EXPECT_EQ(hex(ear.taken()), "00");
}

}  // namespace uart_test
}  // namespace drydock::probe
