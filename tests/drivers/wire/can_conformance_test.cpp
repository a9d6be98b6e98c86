#include <gtest/gtest.h>

#include <algorithm>

#include "drivers/wire/registry.hpp"
#include "tests/drivers/property.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

/// Rules for every CAN protocol of the registry.
namespace drydock::wire {
namespace can_conformance_test {

using test::decode_all;
using test::fixture;

template <class P>
class CanConformance : public ::testing::Test {
 public:
  static std::string folder() { return std::string{P::name}; }
};

template <class List>
struct TestedProtocols;
template <class... P>
struct TestedProtocols<ProtocolList<P...>> {
  using Types = ::testing::Types<P...>;
};
TYPED_TEST_SUITE(CanConformance, TestedProtocols<FrameProtocols>::Types);

/// Identifiers close to those of our protocols, so that mainly the content varies.
CanFrame random_frame() {
  constexpr std::array<std::uint32_t, 28> pgns{
      61481,  61482,  61485,  127245, 127488, 128267, 129029, 130312, 130314, 59904,
      60928,  65280,  126992, 127237, 127250, 127251, 127252, 127257, 127258, 128259,
      128275, 129025, 129026, 129539, 129540, 130310, 130311, 129038};
  CanFrame frame;
  frame.extended = *rc::gen::arbitrary<bool>();
  frame.remote = *rc::gen::weightedElement<bool>({{9, false}, {1, true}});
  frame.error = *rc::gen::weightedElement<bool>({{9, false}, {1, true}});
  const auto pgn = *rc::gen::elementOf(pgns);
  const auto source = *rc::gen::inRange<std::uint32_t>(0, 4);
  const auto standard = *rc::gen::elementOf(
      std::vector<std::uint32_t>{0, 0x80, 0x185, 0x285, 0x385, 0x705, 0x85, 0x7FF});
  frame.id = frame.extended ? 3u << 26 | pgn << 8 | source : standard;
  const auto data = *rc::gen::container<std::vector<std::uint8_t>>(
      *rc::gen::inRange<std::size_t>(0, 9), rc::gen::arbitrary<std::uint8_t>());
  frame.size = static_cast<std::uint8_t>(data.size());
  std::copy(data.begin(), data.end(), frame.data.begin());
  return frame;
}

std::vector<CanFrame> random_traffic(std::size_t most) {
  std::vector<CanFrame> frames(*rc::gen::inRange<std::size_t>(0, most));
  for (CanFrame& frame : frames) frame = random_frame();
  return frames;
}

/// True if every number in a message is finite.
bool shows_only_numbers(const nlohmann::json& message) {
  for (const auto& value : message) {
    if (value.is_structured() && !shows_only_numbers(value)) return false;
    if (value.is_number_float() && !std::isfinite(value.get<double>())) return false;
  }
  return true;
}

TYPED_TEST(CanConformance, GoldenFramesDecodeToTheNumbersOfTheirSources) {
  const auto frames = test::frames_of_log(fixture(this->folder() + "/frames.log"));
  const auto expected = test::lines_of(fixture(this->folder() + "/frames.expected.jsonl"));
  const auto messages = decode_all<TypeParam>(frames);
  ASSERT_GT(expected.size(), 0u);
  ASSERT_EQ(messages.size(), expected.size());
  for (std::size_t i = 0; i < messages.size(); ++i) {
    test::expect_fields(nlohmann::json::parse(expected[i]), test::to_json(messages[i]));
  }
}

TYPED_TEST(CanConformance, MessagesNameTheirFieldsOnceBesideThoseOfTheirFrame) {
  for (const auto& message :
       decode_all<TypeParam>(test::frames_of_log(fixture(this->folder() + "/frames.log")))) {
    std::vector<std::string> keys{"type", "time_s", "interface"};  // decode adds these itself
    std::visit(
        [&](const auto& m) {
          visit_fields(m, [&](std::string_view key, const auto&) { keys.emplace_back(key); });
        },
        message);
    std::ranges::sort(keys);
    const auto twice = std::ranges::adjacent_find(keys);
    EXPECT_EQ(twice, keys.end()) << *twice;
  }
}

TYPED_TEST(CanConformance, ForeignTrafficBetweenGoldenFramesChangesNothing) {
  const auto golden = test::frames_of_log(fixture(this->folder() + "/frames.log"));
  const CanFrame foreign[] = {test::frame("1DEFFFCC#C0083B9FF0819C51"),
                              test::frame("123#0102"),
                              test::frame("20000004#0004000000000000"),
                              test::frame("09F80E02#36729A16021AB80D"),
                              test::frame("7E5#"),
                              test::frame("0CF02980#R8"),
                              test::frame("185#R")};
  std::vector<CanFrame> mixed;
  for (const CanFrame& frame : golden) {
    mixed.push_back(frame);
    mixed.insert(mixed.end(), std::begin(foreign), std::end(foreign));
  }
  const auto alone = decode_all<TypeParam>(golden), among = decode_all<TypeParam>(mixed);
  ASSERT_EQ(among.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(test::to_json(among[i]), test::to_json(alone[i]));
  }
}

TYPED_TEST(CanConformance, EachGoldenFrameCutShortGivesNoMessageAndIsCounted) {
  for (CanFrame frame : test::frames_of_log(fixture(this->folder() + "/frames.log"))) {
    typename TypeParam::Decoder decoder;
    frame.size = 0;
    EXPECT_FALSE(decoder.receive(frame));
    EXPECT_EQ(decoder.counters().frames, 0u);
  }
}

TYPED_TEST(CanConformance, AnyTrafficGivesFiniteNumbersAndHonestCounters) {
  EXPECT_TRUE(holds([] {
    typename TypeParam::Decoder decoder;
    std::uint64_t messages = 0;
    for (const CanFrame& frame : random_traffic(60)) {
      if (const auto message = decoder.receive(frame)) {
        ++messages;
        RC_ASSERT(shows_only_numbers(test::to_json(*message)));
      }
    }
    const StreamCounters& c = decoder.counters();
    RC_ASSERT(c.frames == messages);
    RC_ASSERT(c.bytes_good + c.bytes_skipped <= c.bytes_in);
  }));
}

}  // namespace can_conformance_test
}  // namespace drydock::wire
