// Which bytes a faulty line loses, changes or moves, for any bytes in any pieces: only those that
// its faults explain.
#include <gtest/gtest.h>

#include <bit>
#include <vector>

#include "rig_config/fault_vocabulary.hpp"
#include "tests/drivers/property.hpp"
#include "tests/hil/proxy/faulty_line.hpp"

namespace faulty_stream_bytes_test {

using namespace drydock;
using namespace drydock::fault;
using namespace drydock::fault::testing;

TEST(FaultyStream, WithoutAFaultPassesEachReadOnAsItCame) {
  EXPECT_TRUE(holds([] {
    FaultyLine bench;
    // A fault that is still to come must not matter either.
    if (*rc::gen::arbitrary<bool>())
      bench.schedule->add(fault_of("device='gnss'\nfault='drop'\nstart_s=100"));
    std::vector<Heard::Read> said;
    Stamp at = start;
    for (int i = *rc::gen::inRange(0, 12); i > 0; --i) {
      const auto noise =
          std::string(*rc::gen::inRange<std::size_t>(1, 300), *rc::gen::element('$', '\n'));
      const auto chunk = *rc::gen::element(noise, gga, rmc.substr(0, 30), rmc.substr(30));
      at += 1ms;
      bench.say(chunk, at);
      said.push_back({chunk, at});
    }
    RC_ASSERT(bench.heard.reads == said);
    RC_ASSERT(bench.stream.hits().none());
  }));
}

TEST(FaultyStream, WithFaultsThatNeverStrikeLosesAndMovesNoByte) {
  std::vector<FaultConfig> faults;
  for (const char* kind : {"drop", "flip", "truncate", "bad-checksum", "duplicate", "reorder"})
    faults.push_back(fault_of("device='gnss'\nprobability=0.0\nfault='" + std::string(kind) + "'"));
  EXPECT_TRUE(holds([&] {
    FaultyLine bench;
    for (const auto& fault : faults) bench.schedule->add(fault);
    std::string said;
    Stamp at = start;
    for (int i = *rc::gen::inRange(0, 12); i > 0; --i) {
      const auto noise = *rc::gen::container<std::string>(
          rc::gen::element<char>('$', 'G', '*', '\r', '\n', '4', ','));
      const auto chunk = *rc::gen::element(noise, gga, rmc, gga.substr(0, 30), gga.substr(30));
      at += std::chrono::milliseconds{*rc::gen::element(1, 15, 40)};
      bench.say(chunk, at);
      said += chunk;
      RC_ASSERT(said.starts_with(bench.heard.all()));
    }
    bench.run_until(at + 1s);
    RC_ASSERT(bench.heard.all() == said);
    RC_ASSERT(bench.stream.hits().none());
  }));
}

/// Sentences with noise between them, in any pieces. The noise holds no start of a sentence.
struct Line {
  std::vector<std::string> pieces;
  std::string all;
};

Line any_line() {
  Line line;
  for (int i = *rc::gen::inRange(1, 20); i > 0; --i) {
    const auto noise = *rc::gen::container<std::string>(rc::gen::element<char>('a', 'z', '\0'));
    line.pieces.push_back(*rc::gen::element(noise, gga, rmc));
    line.all += line.pieces.back();
  }
  return line;
}

std::string heard_of(const Line& line, FaultyLine& bench) {
  Stamp at = start;
  for (std::size_t from = 0; from < line.all.size();) {
    const auto size = *rc::gen::inRange<std::size_t>(1, 90);
    at += 1ms;
    bench.say(std::string_view(line.all).substr(from, size), at);
    from += size;
  }
  bench.run_until(at + 1s);
  return bench.heard.all();
}

TEST(FaultyStream, DropTakesWholeMessagesAndNothingElse) {
  const auto half = fault_of("device='gnss'\nfault='drop'\nprobability=0.5");
  EXPECT_TRUE(holds([&] {
    FaultyLine bench;
    bench.schedule->add(half);
    const Line line = any_line();
    const std::string out = heard_of(line, bench);
    std::string_view rest = out;
    std::uint64_t missing = 0;
    for (const auto& piece : line.pieces) {
      const bool is_message = piece.starts_with('$');
      if (rest.starts_with(piece))
        rest.remove_prefix(piece.size());
      else {
        RC_ASSERT(is_message);
        ++missing;
      }
    }
    // If two neighbours are equal, either may be missing; the number of missing ones is the same.
    RC_ASSERT(rest.empty());
    RC_ASSERT(missing == bench.stream.hits()[FaultKind::drop]);
  }));
}

TEST(FaultyStream, FlipTurnsOneBitOfAMessageAndLeavesTheOthersAndTheNoise) {
  const auto half = fault_of("device='gnss'\nfault='flip'\nprobability=0.5");
  EXPECT_TRUE(holds([&] {
    FaultyLine bench;
    bench.schedule->add(half);
    const Line line = any_line();
    const std::string out = heard_of(line, bench);
    RC_ASSERT(out.size() == line.all.size());
    std::size_t at = 0;
    std::uint64_t flipped = 0;
    for (const auto& piece : line.pieces) {
      int bits = 0;
      for (std::size_t i = 0; i < piece.size(); ++i, ++at)
        bits += std::popcount(static_cast<unsigned char>(piece[i] ^ out[at]));
      RC_ASSERT(bits <= (piece.starts_with('$') ? 1 : 0));
      flipped += bits > 0;
    }
    RC_ASSERT(flipped == bench.stream.hits()[FaultKind::flip]);
  }));
}

}  // namespace faulty_stream_bytes_test
