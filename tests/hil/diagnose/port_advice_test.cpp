#include "estimators/host/port_advice.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace drydock::host {
namespace {

TEST(PortAdvice, OfALinkThatHasNoPlugNamesNone) {
  for (const char* link :
       {"tcp:192.168.194.95:16171", "udp:0.0.0.0:4000", "gateway:tcp:10.0.0.7:2598"}) {
    const auto advice = port_advice(link::parse_uri(link)->scheme);
    EXPECT_NE(advice.find("host and port"), std::string_view::npos) << link;
    EXPECT_EQ(advice.find("plug"), std::string_view::npos) << link;
  }
  EXPECT_NE(port_advice(link::Scheme::slcan).find("bit rate"), std::string_view::npos);
}

/// Its interface or pty is made by the devices on it.
TEST(PortAdvice, OfAnEmulatedBusIsToStartItsDevices) {
  EXPECT_EQ(port_advice(link::Scheme::can_auto), port_advice(link::Scheme::pty));
}

TEST(PortAdvice, StandsOnThePageOfFindings) {
  std::ifstream in(DRYDOCK_SOURCE_DIR "/docs/pier/findings.md");
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  for (int i = 0; i <= static_cast<int>(link::Scheme::can_auto); ++i) {
    const auto advice = port_advice(static_cast<link::Scheme>(i));
    EXPECT_NE(page.find(advice), std::string::npos) << advice;
  }
}

}  // namespace
}  // namespace drydock::host
