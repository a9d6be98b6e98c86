// Every fault of the vocabulary on a real receiver's line: it is refused with a line, or it takes
// effect.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string_view>
#include <vector>

#include "rig_config/fault_vocabulary.hpp"
#include "tests/hil/proxy/faulty_line.hpp"

namespace faulty_stream_vocabulary_test {

using namespace drydock;
using namespace drydock::fault;
using namespace drydock::fault::testing;
using rig_config::FaultTarget;

// Every fault of the vocabulary on a real receiver's line is refused with a line, or it begins,
// hits what it says, and clears.
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

    FaultyLine bench;
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
    bench.run_until(start + 5s);  // messages that it held come now
    bench.heard = {};
    said.clear();
    const auto hits = bench.stream.hits()[word.kind];
    say_until(start + 6s, start + 5s);
    EXPECT_EQ(bench.heard.reads, said) << word.name << " after it was cleared";
    EXPECT_TRUE(bench.stream.hears()) << word.name;
    EXPECT_EQ(bench.stream.hits()[word.kind], hits) << word.name;
  }
  EXPECT_THAT(taken, ::testing::IsSupersetOf({"drop", "flip", "truncate", "bad-checksum",
                                              "duplicate", "reorder", "garbage", "unplug", "hang",
                                              "wrong-baud", "eof", "delay", "jitter", "burst"}));
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

}  // namespace faulty_stream_vocabulary_test
