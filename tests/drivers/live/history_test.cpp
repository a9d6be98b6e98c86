#include "drivers/live/history.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "drivers/live/foxglove/foxglove.hpp"

namespace drydock::live {
namespace history_test {

using measurement::Stamp;
using namespace std::chrono_literals;

History::Body body_of(std::size_t size) {
  return std::make_shared<std::vector<std::uint8_t>>(size, std::uint8_t{0x5A});
}

struct Message {
  std::uint32_t channel;
  std::uint64_t time_ns;
  std::size_t size;
  friend bool operator==(const Message&, const Message&) = default;
};

/// Reads the file as docs/use/live.md says it: u32 size, then opcode 1, u32 channel, u64 time,
/// body.
std::vector<Message> messages_of(const History& history) {
  const std::string file = history.file();
  std::vector<Message> all;
  for (std::size_t at = 0; at < file.size();) {
    std::uint32_t size = 0;
    Message message{};
    std::memcpy(&size, file.data() + at, 4);
    EXPECT_EQ(file[at + 4], 1);
    std::memcpy(&message.channel, file.data() + at + 5, 4);
    std::memcpy(&message.time_ns, file.data() + at + 9, 8);
    message.size = size - 13;
    all.push_back(message);
    at += 4 + size;
  }
  return all;
}

TEST(History, GivesTheMessagesInTheOrderInWhichTheyCame) {
  History history(5min);
  history.add(7, Keep::all, Stamp{2s}, body_of(3));
  history.add(1, Keep::all, Stamp{1s}, body_of(0));
  EXPECT_EQ(messages_of(history),
            (std::vector<Message>{{7, 2'000'000'000, 3}, {1, 1'000'000'000, 0}}));
}

TEST(History, ForgetsWhatIsOlderThanItsTime) {
  History history(300s);
  for (int second = 0; second <= 1000; ++second)
    history.add(1, Keep::all, Stamp{std::chrono::seconds(second)}, body_of(10));
  const auto kept = messages_of(history);
  EXPECT_EQ(kept.size(), 301U);
  EXPECT_EQ(kept.front().time_ns, 700'000'000'000U);
}

TEST(History, OfADenseChannelKeepsFiveMessagesASecondAndOfTwoTheSameTimes) {
  History history(300s);
  for (int sample = 0; sample < 250; ++sample)  // ten seconds at 25 Hz
    for (const std::uint32_t channel : {1U, 2U})
      history.add(channel, Keep::some, Stamp{sample * 40ms}, body_of(10));
  const auto kept = messages_of(history);
  ASSERT_EQ(kept.size(), 100U);
  for (std::size_t i = 0; i < kept.size(); i += 2) EXPECT_EQ(kept[i].time_ns, kept[i + 1].time_ns);
}

TEST(History, HoldsNoMoreBytesThanItsBound) {
  History history(300s);
  for (int i = 0; i < 40; ++i) history.add(1, Keep::all, Stamp{i * 1s}, body_of(1u << 20));
  EXPECT_EQ(messages_of(history).size(), History::most_bytes >> 20);
  EXPECT_EQ(messages_of(history).back().time_ns, 39'000'000'000U);
}

TEST(History, BeginsAnewWhenTheTimeGoesBack) {
  History history(300s);
  for (const auto at : {100s, 101s, 96s}) history.add(1, Keep::all, Stamp{at}, body_of(1));
  EXPECT_EQ(messages_of(history).size(), 3U);  // five seconds late is late
  history.add(1, Keep::all, Stamp{3s}, body_of(1));
  EXPECT_EQ(messages_of(history), (std::vector<Message>{{1, 3'000'000'000, 1}}));
}

TEST(History, OfNoTimeKeepsNothing) {
  History history(0s);
  history.add(1, Keep::all, Stamp{1s}, body_of(1));
  EXPECT_TRUE(history.file().empty());
}

}  // namespace history_test
}  // namespace drydock::live
