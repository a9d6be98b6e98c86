#include <gmock/gmock.h>

#include "tests/drivers/described/dbc_bus.hpp"
#include "tests/drivers/described/golden_buses.hpp"
#include "tests/drivers/property.hpp"
#include "tests/test_name.hpp"

/// The rules of every CAN protocol (tests/drivers/wire/can_conformance_test.cpp), for each shipped
/// description of frames.
namespace drydock::described::test {
namespace dbc_conformance_test {

using wire::CanFrame;
using wire::described::FrameDecoder;
using wire::described::Record;
using wire::described::Taken;
using wire::described::Target;

class DescribedBusTest : public ::testing::TestWithParam<GoldenBus> {
 protected:
  /// Type and values of each message.
  std::vector<nlohmann::json> messages_in(const std::vector<CanFrame>& frames) const {
    FrameDecoder decoder(description_);
    std::vector<nlohmann::json> messages;
    for (const CanFrame& one : frames)
      if (const auto message = decoder.receive(one))
        messages.push_back(wire::test::to_json(*message));
    return messages;
  }

  DescriptionPtr description_ = shipped(GetParam().file);
  std::vector<CanFrame> golden_ = GetParam().frames();
};

TEST_P(DescribedBusTest, TakesEveryGoldenFrameOfItsMessagesAndCountsThoseThatAreShort) {
  FrameDecoder decoder(description_);
  Record record;
  std::size_t taken = 0;
  for (const CanFrame& one : golden_) taken += decoder.take(one, record) == Taken::message;
  EXPECT_EQ(taken, GetParam().messages);
  EXPECT_EQ(decoder.counters().frames, GetParam().messages);
  EXPECT_EQ(decoder.counters().bad_checksums, GetParam().shorts);
}

TEST_P(DescribedBusTest, ForeignTrafficBetweenGoldenFramesChangesNothing) {
  std::vector<CanFrame> mixed;
  for (const CanFrame& one : golden_) {
    mixed.push_back(one);
    for (const char* foreign : {"1DEFFFCC#C0083B9FF0819C51", "123#0102", "7E5#", "0CF02980#R8",
                                "032#R", "20000004#0004000000000000"})
      mixed.push_back(frame(foreign));
  }
  EXPECT_EQ(messages_in(mixed), messages_in(golden_));
}

TEST_P(DescribedBusTest, EachGoldenFrameCutShortGivesNoMessageAndIsCounted) {
  for (CanFrame one : golden_) {
    FrameDecoder decoder(description_);
    Record record;
    if (decoder.take(one, record) != Taken::message) continue;
    const auto good = decoder.counters().frames;
    --one.size;
    EXPECT_EQ(decoder.take(one, record), Taken::damaged);
    EXPECT_EQ(decoder.counters().frames, good);
    EXPECT_EQ(decoder.counters().bad_checksums, 1u);
  }
}

TEST_P(DescribedBusTest, AnyTrafficGivesFiniteNumbersAndHonestCounters) {
  EXPECT_TRUE(holds([&] {
    FrameDecoder decoder(description_);
    std::uint64_t messages = 0;
    for (int i = 0; i < 40; ++i) {
      CanFrame one = *rc::gen::elementOf(golden_);
      one.extended = *rc::gen::weightedElement<bool>({{9, one.extended}, {1, !one.extended}});
      one.size = *rc::gen::inRange<std::uint8_t>(0, 9);
      for (std::uint8_t& byte : one.data) byte = *rc::gen::arbitrary<std::uint8_t>();
      const auto message = decoder.receive(one);
      if (!message) continue;
      ++messages;
      visit_fields(std::get<Record>(*message), [](std::string_view, const auto& value) {
        if constexpr (requires { value.has_value(); }) RC_ASSERT(!value || std::isfinite(*value));
      });
    }
    const auto& c = decoder.counters();
    RC_ASSERT(c.frames == messages);
    RC_ASSERT(c.bytes_good + c.bytes_skipped == c.bytes_in);
  }));
}

constexpr int samples = 20, damaged_sample = 10;
constexpr double radps_a_sample = 0.125, mps2_a_sample = 0.5;

/// Sample i says i in all that it measures.
wire::described::Readings readings_of(int i) {
  wire::described::Readings readings;
  for (const auto& row : wire::described::target_rows) readings.set(row.target, 0.01 * i);
  for (const Target rate : {Target::rate_x, Target::rate_y, Target::rate_z})
    readings.set(rate, radps_a_sample * i);
  for (const Target force : {Target::force_x, Target::force_y, Target::force_z})
    readings.set(force, mps2_a_sample * i);
  readings.set(Target::age, 0);
  readings.set(Target::heading_reference, 0);
  return readings;
}

/// The measurements of 20 samples a tenth of a second apart, of which a frame of one does not come.
Heard heard_without(const DescriptionPtr& description, std::optional<std::size_t> lost) {
  Bus bus(description);
  wire::described::FrameEncoder encoder(*description, 0x31);
  for (int i = 1; i <= samples; ++i)
    for (std::size_t place = 0; place < description->plan.messages.size(); ++place)
      if (i != damaged_sample || lost != place)
        bus.says(encoder.encode(place, {}, readings_of(i)).value(),
                 i * 0.1 + static_cast<double>(place) * 0.0003);
  return bus;
}

TEST_P(DescribedBusTest, ALostFrameCostsItsOwnSampleAtMostAndJoinsNoTwo) {
  const auto whole = heard_without(description_, {}).all.size();
  EXPECT_EQ(whole % samples, 0u);
  EXPECT_GT(whole, 0u);
  for (std::size_t lost = 0; lost < description_->plan.messages.size(); ++lost) {
    const auto heard = heard_without(description_, lost);
    EXPECT_GE(heard.all.size() + 1, whole) << description_->plan.messages[lost].name;
    for (const auto& one : heard.all)
      if (const auto* imu = std::get_if<measurement::ImuSample>(&one)) {
        EXPECT_NEAR(imu->angular_rate.z() / radps_a_sample, imu->specific_force.x() / mps2_a_sample,
                    0.05);
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Every, DescribedBusTest, ::testing::ValuesIn(golden_buses()),
                         [](const auto& one) { return drydock::test::test_name(one.param.file); });

TEST(DescribedProtocols, EachShippedDescriptionOfFramesHasGoldenOnes) {
  std::vector<std::string> frames, golden;
  for (const auto& one : rig_config::shipped_descriptions())
    if (one->frames) frames.push_back(one->name);
  for (const auto& one : golden_buses()) golden.push_back(one.file);
  EXPECT_THAT(golden, ::testing::UnorderedElementsAreArray(frames));
}

}  // namespace dbc_conformance_test
}  // namespace drydock::described::test
