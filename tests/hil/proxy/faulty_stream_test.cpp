// When the bytes of a real or recorded device pass its faults, in virtual time.
#include <gtest/gtest.h>

#include "tests/hil/proxy/faulty_line.hpp"

namespace faulty_stream_test {

using namespace drydock;
using namespace drydock::fault;
using namespace drydock::fault::testing;

TEST(FaultyStream, AMessageGoesOnWithItsLastByteAndIsStampedWithIt) {
  FaultyLine bench;
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
  FaultyLine bench;
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
  FaultyLine bench;
  bench.schedule->add(fault_of("device='gnss'\nfault='reorder'\nprobability=1.0\nfor_s=1"));
  bench.say(gga + "$GPR", start + 990ms);  // the first waits for its successor, the second is
                                           // incomplete
  EXPECT_EQ(bench.heard.all(), "");
  bench.say(rmc.substr(4), start + 1010ms);
  EXPECT_EQ(bench.heard.all(), gga + rmc);
}

TEST(FaultyStream, WhileUnpluggedNothingPassesEitherWayAndNothingComesLate) {
  FaultyLine bench;
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

TEST(FaultyStream, WithoutAProtocolDelaysWholeReads) {
  FaultyLine bench(receiver(""));
  bench.schedule->add(fault_of("device='gnss'\nfault='delay'\nseconds=0.25"));
  bench.say("ab", start + 1ms);
  bench.say("cd", start + 2ms);
  bench.run_until(start + 1s);
  EXPECT_EQ(bench.heard.reads,
            (std::vector<Heard::Read>{{"ab", start + 251ms}, {"cd", start + 252ms}}));
}

}  // namespace faulty_stream_test
