// The bytes of a real or recorded device under faults, in virtual time.
#include "hil/fault/faulty_stream.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/drivers/property.hpp"
#include "tests/hil/proxy/outlet.hpp"

namespace faulty_stream_test {

using namespace drydock;
using namespace drydock::fault;
using namespace drydock::fault::testing;
using rig_config::FaultTarget;

DeviceConfig receiver(const std::string& protocol = "nmea0183") {
  DeviceConfig device;
  device.name = "gnss";
  device.kind = rig_config::DeviceKind::gnss;
  device.protocol = protocol;
  device.link = "serial:/dev/ttyUSB0?baud=9600";
  return device;
}

/// A device's line with its faults and the drivers behind it; time goes from deadline to deadline.
struct Bench {
  explicit Bench(const DeviceConfig& device = receiver())
      : schedule(std::make_shared<Schedule>(start)), stream(device, 7, schedule, start) {}

  void run_until(Stamp at) {
    for (auto due = stream.deadline(); due && *due <= at; due = stream.deadline()) {
      now = std::max(now, *due);
      stream.tick(now, heard);
    }
    now = at;
  }
  void say(std::string_view text, Stamp at) {
    run_until(at);
    stream.receive(bytes_of(text), at, heard);
  }

  std::shared_ptr<Schedule> schedule;
  FaultyStream stream;
  Heard heard;
  Stamp now = start;
};

TEST(FaultyStream, WithoutAFaultPassesEachReadOnAsItCame) {
  EXPECT_TRUE(holds([] {
    Bench bench;
    // One that is still to come must not matter either.
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
    Bench bench;
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

/// Sentences and noise between them, in any split; the noise holds no start of a sentence.
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

std::string heard_of(const Line& line, Bench& bench) {
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
    Bench bench;
    bench.schedule->add(half);
    const Line line = any_line();
    const std::string out = heard_of(line, bench);
    std::string_view rest = out;
    std::uint64_t missing = 0, messages = 0;
    for (const auto& piece : line.pieces) {
      const bool is_message = piece.starts_with('$');
      messages += is_message;
      if (rest.starts_with(piece))
        rest.remove_prefix(piece.size());
      else {
        RC_ASSERT(is_message);
        ++missing;
      }
    }
    // Of two equal neighbours either may be the one that is missing; how many are is the same.
    RC_ASSERT(rest.empty());
    RC_ASSERT(missing == bench.stream.hits()[FaultKind::drop]);
  }));
}

TEST(FaultyStream, FlipTurnsOneBitOfAMessageAndLeavesTheOthersAndTheNoise) {
  const auto half = fault_of("device='gnss'\nfault='flip'\nprobability=0.5");
  EXPECT_TRUE(holds([&] {
    Bench bench;
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

TEST(FaultyStream, AMessageGoesOnWithItsLastByteAndIsStampedWithIt) {
  Bench bench;
  bench.schedule->add(fault_of("device='gnss'\nfault='drop'\nprobability=0.0"));
  bench.say(gga.substr(0, 40), start + 1ms);
  EXPECT_TRUE(bench.heard.reads.empty());
  bench.say(gga.substr(40) + rmc.substr(0, 9), start + 15ms);
  ASSERT_EQ(bench.heard.reads.size(), 1u);
  EXPECT_EQ(bench.heard.reads[0].bytes, gga);
  // Nine bytes of 10 bits at 9600 baud came after it.
  EXPECT_NEAR(measurement::seconds(start + 15ms - bench.heard.reads[0].at), 9 * 10 / 9600.0, 1e-7);
}

TEST(FaultyStream, WhatIsNoWholeMessageWaitsForTheLinesSilenceAlone) {
  Bench bench;
  bench.schedule->add(fault_of("device='gnss'\nfault='drop'\nprobability=1.0"));
  bench.say(gga.substr(0, 40), start + 1ms);
  const auto due = bench.stream.deadline();
  ASSERT_TRUE(due);
  EXPECT_NEAR(measurement::seconds(*due - (start + 1ms)), 0.020 + 2 * 10 / 9600.0, 1e-6);
  bench.run_until(start + 30ms);
  EXPECT_EQ(bench.heard.all(), gga.substr(0, 40));
}

TEST(FaultyStream, OneSeedGivesOneOutputAndAnotherAnother) {
  const auto all_with = [](std::uint64_t seed) {
    auto schedule = std::make_shared<Schedule>(start);
    schedule->add(fault_of("device='gnss'\nfault='drop'\nprobability=0.5"));
    FaultyStream stream(receiver(), seed, schedule, start);
    Heard heard;
    for (int i = 0; i < 64; ++i)
      stream.receive(bytes_of(i % 2 == 0 ? gga : rmc), start + i * 10ms, heard);
    return heard.all();
  };
  EXPECT_EQ(all_with(1), all_with(1));
  EXPECT_NE(all_with(1), all_with(2));
}

TEST(FaultyStream, WhenAFaultEndsWhatItHeldComesInItsPlace) {
  Bench bench;
  bench.schedule->add(fault_of("device='gnss'\nfault='reorder'\nprobability=1.0\nfor_s=1"));
  bench.say(gga + "$GPR", start + 990ms);  // the first waits for its successor, the second is cut
  EXPECT_EQ(bench.heard.all(), "");
  bench.say(rmc.substr(4), start + 1010ms);
  EXPECT_EQ(bench.heard.all(), gga + rmc);
}

TEST(FaultyStream, WhileUnpluggedNothingPassesEitherWayAndNothingComesLate) {
  Bench bench;
  bench.schedule->add(fault_of("device='gnss'\nfault='delay'\nseconds=0.5\nfor_s=1"));
  bench.schedule->add(fault_of("device='gnss'\nfault='unplug'\nstart_s=1\nfor_s=1"));
  bench.say(gga, start + 900ms);
  bench.say(rmc, start + 1500ms);
  EXPECT_FALSE(bench.stream.hears());
  EXPECT_FALSE(bench.stream.has_port());
  bench.say(gga, start + 2500ms);
  EXPECT_TRUE(bench.stream.hears());
  EXPECT_EQ(bench.heard.reads, (std::vector<Heard::Read>{{gga, start + 2500ms}}));
  EXPECT_EQ(bench.heard.ports, (std::vector<Heard::Port>{{false, start + 1s}, {true, start + 2s}}));
}

// Every word of the vocabulary, as it meets a real receiver: refused with a line, or it sets, hits
// what it says, and clears.
TEST(FaultyStream, EachFaultOfTheVocabularyIsRefusedOrSetsAndClears) {
  using namespace std::string_literals;
  const std::map<std::string_view, std::string> with_amount{{"wrong-baud", "baud=4800"}};
  std::vector<std::string_view> taken;
  for (const auto& word : rig_config::fault_vocabulary()) {
    if (word.amount == "quantity" || word.name == "clock-step") {
      FaultConfig asked;
      asked.kind = word.kind;
      EXPECT_TRUE(refusal(asked, receiver(), FaultTarget::proxied)) << word.name;
      continue;
    }
    auto keys = "device='gnss'\nfault='" + std::string(word.name) + "'\n";
    if (with_amount.contains(word.name)) keys += with_amount.at(word.name);
    if (word.amount == "probability") keys += "probability=1.0";
    const auto asked = fault_of(keys);
    if (const auto why = refusal(asked, receiver(), FaultTarget::proxied)) {
      EXPECT_THAT(*why, ::testing::HasSubstr("\""s + std::string(word.name) + "\"")) << word.name;
      continue;
    }
    taken.push_back(word.name);

    Bench bench;
    std::vector<Heard::Read> said;
    const auto say_until = [&](Stamp end, Stamp from) {
      for (Stamp at = from; at < end; at += 100ms) {
        const auto& sentence = said.size() % 2 == 0 ? gga : rmc;
        bench.say(sentence, at);
        said.push_back({sentence, at});
      }
      bench.run_until(end);
    };
    say_until(start + 1s, start);
    EXPECT_EQ(bench.heard.reads, said) << word.name << " before it was set";

    bench.schedule->set(asked, start + 1s);
    say_until(start + 3s, start + 1s);
    EXPECT_TRUE(bench.heard.reads != said || !bench.heard.ports.empty()) << word.name;
    EXPECT_GT(bench.stream.hits()[word.kind], 0u) << word.name;

    EXPECT_EQ(bench.schedule->clear(word.kind), 1u);
    bench.run_until(start + 5s);  // what it held comes
    bench.heard = {};
    said.clear();
    const auto hits = bench.stream.hits()[word.kind];
    say_until(start + 6s, start + 5s);
    EXPECT_EQ(bench.heard.reads, said) << word.name << " after it was cleared";
    EXPECT_TRUE(bench.stream.hears()) << word.name;
    EXPECT_EQ(bench.stream.hits()[word.kind], hits) << word.name;
  }
  EXPECT_EQ(taken,
            (std::vector<std::string_view>{"drop", "flip", "truncate", "bad-checksum", "duplicate",
                                           "reorder", "garbage", "unplug", "hang", "wrong-baud",
                                           "eof", "delay", "jitter", "burst"}));
}

TEST(FaultyStream, WithoutAProtocolOrABaudRateSaysWhatItCannotDo) {
  const auto drop = fault_of("device='gnss'\nfault='drop'");
  EXPECT_THAT(*refusal(drop, receiver(""), FaultTarget::proxied),
              ::testing::HasSubstr("--protocol"));
  auto device = receiver();
  device.link = "pty:gnss";
  const auto baud = fault_of("device='gnss'\nfault='wrong-baud'\nbaud=4800");
  for (const auto target : {FaultTarget::emulated, FaultTarget::replayed, FaultTarget::proxied})
    EXPECT_THAT(*refusal(baud, device, target), ::testing::HasSubstr("?baud="));
}

TEST(FaultyStream, WithoutAProtocolDelaysWholeReads) {
  Bench bench(receiver(""));
  bench.schedule->add(fault_of("device='gnss'\nfault='delay'\nseconds=0.25"));
  bench.say("ab", start + 1ms);
  bench.say("cd", start + 2ms);
  bench.run_until(start + 1s);
  EXPECT_EQ(bench.heard.reads,
            (std::vector<Heard::Read>{{"ab", start + 251ms}, {"cd", start + 252ms}}));
}

}  // namespace faulty_stream_test
