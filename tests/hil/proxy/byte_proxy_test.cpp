// A proxy between two ptys: bytes, faults, and sides that go and come back.
#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>

#include "rig_config/fault_vocabulary.hpp"
#include "tests/hil/proxy/proxy_between.hpp"

namespace byte_proxy_test {

using namespace drydock;
using namespace drydock::proxy::testing;
using fault::FaultKind;
using link::Side;

/// The device is on one pty, the drivers on another.
class ByteProxy : public ::testing::Test {
 protected:
  ByteProxy() {
    device_ = open(between_.io, real_, Side::device);
    EXPECT_TRUE(between_.until_said("drivers: "));
    drivers_ = open(between_.io, virtual_, Side::driver);
  }
  ~ByteProxy() override {
    device_->close();
    drivers_->close();
    settle(between_.io);
  }

  std::string heard(std::size_t size) {
    const auto read = run(between_.io, read_bytes(*drivers_, size));
    return read ? std::string(read->begin(), read->end()) : "";
  }
  void say(const std::string& text) { ASSERT_TRUE(run(between_.io, device_->write(bytes(text)))); }

  std::string real_ = "pty:" + unique("proxy-real"), virtual_ = "pty:" + unique("proxy-virtual");
  ProxyBetween between_{real_, virtual_};
  std::unique_ptr<link::ByteLink> device_, drivers_;
};

TEST_F(ByteProxy, PassesBothWaysAndCounts) {
  say("hello");
  EXPECT_EQ(heard(5), "hello");
  ASSERT_TRUE(run(between_.io, drivers_->write(bytes("set"))));
  const auto read = run(between_.io, read_bytes(*device_, 3));
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, bytes("set"));
  const auto passed = between_.proxy->passed();
  EXPECT_EQ(passed.from_device, 5u);
  EXPECT_EQ(passed.to_drivers, 5u);
  EXPECT_EQ(passed.from_drivers, 3u);
  EXPECT_EQ(passed.to_device, 3u);
  EXPECT_EQ(passed.lost, 0u);
  EXPECT_TRUE(between_.proxy->hits().none());
  EXPECT_EQ(between_.proxy->latency().count(), 1u);
}

TEST_F(ByteProxy, AFaultSetWhileItRunsHitsAndClears) {
  const auto& gga = fault::testing::gga;
  between_.set("fault='drop'\nprobability=1.0");
  say(gga);
  run_until(between_.io, [&] { return between_.proxy->hits()[FaultKind::drop] == 1; });
  between_.clear();
  say("after");
  EXPECT_EQ(heard(5), "after");
  EXPECT_EQ(between_.proxy->hits()[FaultKind::drop], 1u);
}

TEST_F(ByteProxy, WhatADelayHoldsComesByItself) {
  between_.set("fault='delay'\nseconds=0.05");
  const auto before = link::now();
  say(fault::testing::gga);
  EXPECT_EQ(heard(fault::testing::gga.size()), fault::testing::gga);
  EXPECT_GE(link::now() - before, 50ms);
}

TEST_F(ByteProxy, UnpluggedTheVirtualSideVanishesAndComesBackAndTheRealOneStays) {
  between_.set("fault='unplug'");
  std::array<std::uint8_t, 8> buffer{};
  EXPECT_FALSE(run(between_.io, drivers_->read(buffer)));  // the line is gone
  drivers_->close();
  EXPECT_FALSE(link::open_bytes(between_.io.get_executor(), link::parse_uri(virtual_).value(),
                                Side::driver));
  say("lost");
  run_until(between_.io, [&] { return between_.proxy->passed().from_device == 4; });
  between_.clear();
  ASSERT_TRUE(between_.until_said("drivers: ", 2));
  drivers_ = open(between_.io, virtual_, Side::driver);
  say("back");
  EXPECT_EQ(heard(4), "back");
  EXPECT_EQ(between_.proxy->hits()[FaultKind::unplug], 1u);
}

TEST_F(ByteProxy, AtEndOfFileTheVirtualSideHangsUpOnceAndCanBeOpenedAgain) {
  between_.set("fault='eof'");
  std::array<std::uint8_t, 8> buffer{};
  EXPECT_FALSE(run(between_.io, drivers_->read(buffer)));
  drivers_->close();
  ASSERT_TRUE(between_.until_said("drivers: ", 2));
  drivers_ = open(between_.io, virtual_, Side::driver);
  say("again");
  EXPECT_EQ(heard(5), "again");
}

TEST_F(ByteProxy, HungNothingPassesEitherWay) {
  between_.set("fault='hang'");
  say("unheard");
  ASSERT_TRUE(run(between_.io, drivers_->write(bytes("unheard too"))));
  settle(between_.io);
  between_.clear();
  settle(between_.io);
  say("heard");
  EXPECT_EQ(heard(5), "heard");
  EXPECT_EQ(between_.proxy->passed().to_device, 0u);
}

TEST_F(ByteProxy, ARealSideThatGoesIsToldOfOnceTakesTheVirtualOneAlongAndComesBack) {
  device_->close();
  ASSERT_TRUE(between_.until_said("retry"));
  std::array<std::uint8_t, 8> buffer{};
  EXPECT_FALSE(run(between_.io, drivers_->read(buffer)));
  drivers_->close();
  between_.io.restart();
  between_.io.run_for(900ms);  // its attempts fail
  const auto lines = between_.said.size();
  EXPECT_EQ(lines, 3u) << between_.said.back();
  device_ = open(between_.io, real_, Side::device);
  ASSERT_TRUE(between_.until_said("drivers: ", 2));
  drivers_ = open(between_.io, virtual_, Side::driver);
  say("back");
  EXPECT_EQ(heard(4), "back");
}

/// The drivers' side is a line whose reader takes nothing once 64 KiB wait.
TEST(AByteProxy, GoesOnReadingTheDeviceWhileNobodyTakesWhatItSaysAndCountsTheLoss) {
  const std::string real = "pty:" + unique("proxy-deaf");
  ProxyBetween between(real, "memory:proxy-deaf");
  const auto device = open(between.io, real, Side::device);
  ASSERT_TRUE(between.until_said("drivers: "));
  const auto drivers = open(between.io, "memory:proxy-deaf", Side::driver);
  constexpr std::uint64_t all = 100 * 4096;
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(run(between.io, device->write(Buffer(4096, 'x'))));
  ASSERT_TRUE(run_until(between.io, [&] { return between.proxy->passed().from_device == all; }));
  settle(between.io);
  EXPECT_GT(between.proxy->passed().lost, 0u);
  EXPECT_TRUE(between.until_said("takes nothing", 1));
  device->close();  // the virtual side goes with it
  drivers->close();
  ASSERT_TRUE(between.until_said("retry"));
  settle(between.io);
  const auto passed = between.proxy->passed();
  EXPECT_EQ(passed.to_drivers + passed.lost, all);
}

}  // namespace byte_proxy_test
