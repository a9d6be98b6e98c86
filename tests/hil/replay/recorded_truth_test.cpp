#include "hil/replay/recorded_truth.hpp"

#include <gtest/gtest.h>

namespace drydock::replay {
namespace recorded_truth_test {

struct Ear final : host::Follower {
  void on_truth(const host::Estimate&) override { ++told; }
  int told = 0;
};

/// Any program may publish on these topics.
TEST(RecordedTruth, AMessageOfAnotherTypeIsNone) {
  Ear ear;
  RecordedTruth truth(ear);
  const mcap::Schema schema{1, "std_msgs/msg/UInt8", "ros2msg", "uint8 data\n"};
  const std::vector<std::uint8_t> cdr{0, 1, 0, 0, 7};
  std::uint16_t id = 1;
  for (const char* topic : {"/estimate/truth", "/estimate/truth/odometry", "/estimate/truth/fix"}) {
    const mcap::Channel channel{id++, 1, topic, "cdr", {}};
    truth.hear({&channel, &schema, {}, cdr});
  }
  truth.tell();
  EXPECT_EQ(ear.told, 0);
}

}  // namespace recorded_truth_test
}  // namespace drydock::replay
