#include <gtest/gtest.h>

#include <cstdio>
#include <functional>
#include <regex>
#include <sstream>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/can/candump.hpp"
#include "tests/drivers/capture/captures.hpp"

/// Compares CAN captures made by others with scanners of a few lines and with can-utils' asc2log.
namespace drydock::capture::testing {
namespace corpora_test {

namespace fs = std::filesystem;

class Corpora : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(wire::testing::corpora())) GTEST_SKIP() << "no captures";
  }
  /// Every file in the corpora that Drydock recognises as this format.
  static std::vector<fs::path> files_of(std::string_view format) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(wire::testing::corpora())) {
      if (!entry.is_regular_file()) continue;
      Buffer head = wire::testing::read_file(entry.path());
      head.resize(std::min(head.size(), head_to_recognise));
      const Format* recognised = recognise(head, true);
      if (recognised != nullptr && recognised->name == format) found.push_back(entry.path());
    }
    return found;
  }
};

std::size_t lines_matching(const fs::path& file, const std::string& pattern) {
  const std::regex regex(pattern, std::regex::optimize);
  const Buffer bytes = wire::testing::read_file(file);
  std::istringstream lines(std::string(bytes.begin(), bytes.end()));
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) count += std::regex_search(line, regex);
  return count;
}

void expect_counts(const std::vector<fs::path>& files, const std::string& pattern,
                   std::size_t at_least) {
  std::size_t all = 0;
  for (const fs::path& file : files) {
    const Outcome outcome = read_capture(wire::testing::read_file(file));
    EXPECT_EQ(outcome.records.size(), lines_matching(file, pattern)) << file;
    all += outcome.records.size();
  }
  EXPECT_GE(all, at_least);
}

TEST_F(Corpora, EveryLineOfCandumpIsAFrame) {
  expect_counts(files_of("candump-log"), R"(^\(\d+\.\d+\) \w+ [0-9A-F]{3,8}#)", 10'000);
  expect_counts(files_of("candump-screen"), R"(^<0x[0-9a-f]+> \[\d\] [0-9a-f ]+)", 4'000);
}

TEST_F(Corpora, EveryFrameLineOfAscIsAFrame) {
  expect_counts(files_of("asc"), R"(^ *\d+\.\d+ +(CANFD +)?\d+ .*( [dr] |ErrorFrame))", 10);
}

TEST_F(Corpora, EveryLineOfActisenseGivesTheFramesOfItsMessage) {
  for (const fs::path& file : files_of("actisense")) {
    const Outcome outcome = read_capture(wire::testing::read_file(file));
    EXPECT_EQ(outcome.units, lines_matching(file, R"(^A\d{6}\.\d+ [0-9A-F]{5} [0-9A-F]{5} )"));
    EXPECT_EQ(outcome.damaged, 0U) << file;
  }
}

TEST_F(Corpora, EveryPacketOfAPcapIsAFrame) {
  std::size_t all = 0;
  for (const fs::path& file : files_of("pcap")) {
    const Buffer bytes = wire::testing::read_file(file);
    const Outcome outcome = read_capture(bytes);
    std::size_t at = 24, packets = 0;
    for (; at + 16 <= bytes.size(); ++packets) {
      const auto size = wire::load_le<std::uint32_t>(bytes, at + 8);
      ASSERT_LT(packets, outcome.records.size());
      const Seen& seen = outcome.records[packets];
      ASSERT_EQ(seen.frame.id, wire::load_be<std::uint32_t>(bytes, at + 16) & 0x1FFFFFFF);
      ASSERT_EQ(seen.frame.size, bytes[at + 20]);
      ASSERT_TRUE(std::equal(seen.frame.data.begin(), seen.frame.data.begin() + seen.frame.size,
                             bytes.begin() + static_cast<long>(at) + 24));
      at += 16 + size;
    }
    EXPECT_EQ(outcome.records.size(), packets);
    EXPECT_EQ(outcome.damaged, 0u);
    all += packets;
  }
  EXPECT_GT(all, 10'000u);
}

/// The lines that a program prints. Empty if it cannot run.
std::vector<std::string> lines_of_program(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::vector<std::string> lines;
  for (char text[512]; pipe && std::fgets(text, sizeof text, pipe.get()) != nullptr;) {
    lines.emplace_back(text, std::strcspn(text, "\n"));
  }
  return lines;
}

TEST_F(Corpora, Asc2logReadsTheSameFrames) {
  std::size_t compared = 0;
  for (const fs::path& file : files_of("asc")) {
    const auto lines = lines_of_program("asc2log -I '" + file.string() + "' 2>/dev/null");
    if (lines.empty()) GTEST_SKIP() << "asc2log of can-utils is absent";
    const auto ours = read_capture(wire::testing::read_file(file)).records;
    // asc2log skips the error frames of CAN FD lines. Thus our list may be longer, but in the same
    // order.
    auto next = ours.begin();
    for (const std::string& line : lines) {
      const auto theirs = wire::candump::parse_line(line);
      ASSERT_TRUE(theirs) << line;
      next = std::find_if(next, ours.end(), [&](const Seen& seen) {
        return seen.frame == theirs->frame && seen.interface == theirs->interface;
      });
      ASSERT_NE(next, ours.end()) << file << ": " << line;
      ++next;
      ++compared;
    }
  }
  EXPECT_GE(compared, 10u);
}

}  // namespace corpora_test
}  // namespace drydock::capture::testing
