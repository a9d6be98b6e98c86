#include "drivers/live/foxglove/access.hpp"

#include <gtest/gtest.h>

namespace drydock::live {
namespace access_test {

bool may(const Knock& knock, std::string_view token = {}) { return !refusal(knock, token); }

TEST(Access, WithoutATokenOnlyLoopbackNamesAndNoForeignPage) {
  EXPECT_TRUE(may({"/", "localhost:8765", ""}));
  EXPECT_TRUE(may({"/", "127.0.0.1:8765", "http://127.0.0.1:8765"}));
  EXPECT_TRUE(may({"/", "[::1]:8765", "http://localhost:8765"}));
  EXPECT_TRUE(may({"/", "localhost:8765", "file://"}));
  // A web page that made its own name resolve to this machine (DNS rebinding).
  EXPECT_FALSE(may({"/", "evil.example:8765", "http://evil.example:8765"}));
  // A web page that opens a WebSocket to this machine.
  EXPECT_FALSE(may({"/", "localhost:8765", "https://evil.example"}));
  EXPECT_FALSE(may({"/", "localhost:8765", "https://localhost.evil.example"}));
  EXPECT_FALSE(may({"/", "", ""}));
  // A name that begins like an address, and a page in a frame that hides its origin.
  EXPECT_FALSE(may({"/", "127.evil.example:8765", ""}));
  EXPECT_FALSE(may({"/", "localhost:8765", "http://127.0.0.1.evil.example"}));
  EXPECT_FALSE(may({"/", "localhost:8765", "null"}));
}

TEST(Access, WithATokenOnlyWhoKnowsIt) {
  EXPECT_TRUE(may({"/?token=abc", "rig.local:80", "https://app.example"}, "abc"));
  EXPECT_TRUE(may({"/x?a=1&token=abc", "rig.local:80", ""}, "abc"));
  EXPECT_FALSE(may({"/?token=ab", "localhost:80", ""}, "abc"));
  EXPECT_FALSE(may({"/?nottoken=abc", "localhost:80", ""}, "abc"));
  EXPECT_FALSE(may({"/", "localhost:80", ""}, "abc"));
}

TEST(Access, LoopbackIsWhatNeverLeavesTheMachine) {
  for (const auto* local : {"127.0.0.1", "127.1.2.3", "::1", "localhost"})
    EXPECT_TRUE(is_loopback(local)) << local;
  for (const auto* other : {"0.0.0.0", "192.168.1.7", "::", "rig.local", "", "127.", "127.0.0",
                            "127.0.0.1.", "127..0.1", "127.0.0.1x"})
    EXPECT_FALSE(is_loopback(other)) << other;
}

}  // namespace access_test
}  // namespace drydock::live
