#include <gmock/gmock.h>

#include <cstring>

#include "drivers/link/can/can_interface.hpp"
#include "tests/drivers/link/running.hpp"

namespace drydock::link::testing {
namespace {

using wire::CanFrame;

CanFrame extended(std::uint32_t id, std::initializer_list<std::uint8_t> data) {
  CanFrame frame;
  frame.id = id;
  frame.extended = true;
  frame.size = static_cast<std::uint8_t>(data.size());
  std::copy(data.begin(), data.end(), frame.data.begin());
  return frame;
}

CanFrame standard(std::uint32_t id, std::initializer_list<std::uint8_t> data) {
  CanFrame frame = extended(id, data);
  frame.extended = false;
  return frame;
}

TEST(MemoryCan, EachMemberHearsAllOthersButNotItself) {
  asio::io_context io;
  const auto a = open_bus(io, "memory-can:bus", Side::device);
  const auto b = open_bus(io, "memory-can:bus", Side::driver);
  const auto c = open_bus(io, "memory-can:bus", Side::driver);
  const auto stranger = open_bus(io, "memory-can:elsewhere", Side::driver);
  const auto own = start(io, a->read());
  const auto foreign = start(io, stranger->read());

  const CanFrame sent = extended(0x09F11201, {1, 2, 3});
  ASSERT_TRUE(run(io, a->write(sent)));
  EXPECT_EQ(run(io, b->read())->frame, sent);
  EXPECT_EQ(run(io, c->read())->frame, sent);
  settle(io);
  EXPECT_FALSE(own->outcome);
  EXPECT_FALSE(foreign->outcome);
  a->close();
  stranger->close();
  settle(io);
}

TEST(MemoryCan, AFullQueueLosesTheNewestAndCounts) {
  asio::io_context io;
  const auto sender = open_bus(io, "memory-can:full", Side::device);
  const auto sleeper = open_bus(io, "memory-can:full", Side::driver);
  for (unsigned i = 0; i < 1500; ++i) ASSERT_TRUE(run(io, sender->write(standard(i % 2048, {}))));
  EXPECT_EQ(sleeper->dropped(), 1500U - 1024U);
  EXPECT_EQ(run(io, sleeper->read())->frame.id, 0U);
}

TEST(MemoryCan, ClosingEndsAPendingRead) {
  asio::io_context io;
  const auto bus = open_bus(io, "memory-can:closing", Side::driver);
  const auto pending = start(io, bus->read());
  settle(io);
  bus->close();
  ASSERT_TRUE(run_until(io, [&] { return pending->outcome.has_value(); }));
  EXPECT_EQ(pending->outcome->error(), asio::error::operation_aborted);
  EXPECT_EQ(run(io, bus->write(standard(1, {}))).error(), asio::error::operation_aborted);
}

class Slcan : public ::testing::TestWithParam<const char*> {
 protected:
  std::string line() const {
    return GetParam() == std::string("pty") ? "pty:" + folder.file("can") : "memory:can";
  }
  Folder folder;
  asio::io_context io;
};

// The lines follow the slcan protocol (LAWICEL manual, can-utils slcanpty.c).
TEST_P(Slcan, OpensTheChannelAndThenSendsLines) {
  const auto adapter = open(io, line(), Side::device);
  const auto bus = open_bus(io, "slcan:" + line() + "?bitrate=250000", Side::driver);
  ASSERT_TRUE(run(io, bus->write(standard(0x123, {0xAA, 0xBB, 0xCC}))));
  ASSERT_TRUE(run(io, bus->write(extended(0x09F11201, {0x01}))));
  const Buffer expected = bytes("\rC\rS5\rO\rt1233AABBCC\rT09F11201101\r");
  EXPECT_EQ(run(io, read_bytes(*adapter, expected.size())).value(), expected);
}

TEST_P(Slcan, HearsFramesBetweenTheAdaptersAnswers) {
  const auto adapter = open(io, line(), Side::device);
  const auto bus = open_bus(io, "slcan:" + line(), Side::driver);
  const auto reading = start(io, bus->read());
  for (const auto& [command, answer] : {std::pair("\rC\r", "\r\a"),
                                        {"S5\r", "\r"},
                                        {"O\r", "\rz\rt1233AABBCC\rZ\rT1CFF00FF212341234\r"}}) {
    ASSERT_EQ(run(io, read_bytes(*adapter, std::strlen(command))).value(), bytes(command));
    ASSERT_TRUE(run(io, adapter->write(bytes(answer))));
  }
  ASSERT_TRUE(run_until(io, [&] { return reading->outcome.has_value(); }));
  EXPECT_EQ(reading->outcome->value().frame, standard(0x123, {0xAA, 0xBB, 0xCC}));
  EXPECT_EQ(run(io, bus->read())->frame, extended(0x1CFF00FF, {0x12, 0x34}));
}

TEST_P(Slcan, ReadingAndWritingFirstAtOnceOpensOnce) {
  const auto adapter = open(io, line(), Side::device);
  const auto bus = open_bus(io, "slcan:" + line(), Side::driver);
  const CanFrame frame = standard(1, {});
  const auto reading = start(io, bus->read());
  const auto writing = start(io, bus->write(frame));
  const Buffer expected = bytes("\rC\rS5\rO\rt0010\r");
  EXPECT_EQ(run(io, read_bytes(*adapter, expected.size())).value(), expected);
  bus->close();
  settle(io);
}

TEST_P(Slcan, ADeviceSideIsAnAdapterThatAnswers) {
  const auto device = open_bus(io, "slcan:" + line(), Side::device);
  const auto program = open(io, line(), Side::driver);
  ASSERT_TRUE(run(io, program->write(bytes("C\rS5\rO\rS9\rV\rt1233AABBCC\r"))));
  const Buffer answers = bytes("\r\r\r\aV1013\rz\r");
  EXPECT_EQ(run(io, read_bytes(*program, answers.size())).value(), answers);
  EXPECT_EQ(run(io, device->read())->frame, standard(0x123, {0xAA, 0xBB, 0xCC}));
  ASSERT_TRUE(run(io, device->write(extended(0x09F11201, {0x01}))));
  EXPECT_EQ(run(io, read_bytes(*program, 13)).value(), bytes("T09F11201101\r"));
}

TEST_P(Slcan, AFrameWithoutAFormOnThisLineIsAnError) {
  const auto adapter = open(io, line(), Side::device);
  const auto bus = open_bus(io, "slcan:" + line(), Side::driver);
  CanFrame fd = standard(1, {});
  fd.fd = true;
  EXPECT_EQ(run(io, bus->write(fd)).error(), asio::error::operation_not_supported);
}

INSTANTIATE_TEST_SUITE_P(Over, Slcan, ::testing::Values("pty", "memory"),
                         [](const auto& over) { return std::string(over.param); });

class CanAuto : public ::testing::Test {
 protected:
  CanAuto() { ::setenv("XDG_RUNTIME_DIR", folder.file("").c_str(), 1); }
  ~CanAuto() override { ::unsetenv("XDG_RUNTIME_DIR"); }
  bool has_kernel_bus() const { return can_auto_level(uri).ends_with("of the kernel"); }

  Folder folder;
  asio::io_context io;
  std::string name = "drydock" + std::to_string(::getpid() % 10'000);
  Uri uri = parse_uri("can:auto?name=" + name).value();
};

TEST_F(CanAuto, DriverMeetsDeviceAndTheLevelIsSaid) {
  const auto device = open_bus(io, uri.text, Side::device);
  const auto driver = open_bus(io, uri.text, Side::driver);
  EXPECT_THAT(can_auto_level(uri),
              ::testing::AnyOf(name + " of the kernel", "slcan on the pty " + pty_path(name)));
  const CanFrame there = extended(0x18FF0001, {1, 2}), back = standard(0x181, {3});
  ASSERT_TRUE(run(io, driver->write(back)));
  EXPECT_EQ(run(io, device->read())->frame, back);
  ASSERT_TRUE(run(io, device->write(there)));
  EXPECT_EQ(run(io, driver->read())->frame, there);
  EXPECT_EQ(driver->provenance(), Provenance::emulated);
  EXPECT_EQ(device->provenance(), Provenance::emulated);
}

TEST_F(CanAuto, OtherProgramsAndFurtherDevicesJoinTheSlcanBus) {
  const auto device = open_bus(io, uri.text, Side::device);
  if (has_kernel_bus()) GTEST_SKIP() << "the kernel has the bus: no pty to join";
  const auto other_device = open_bus(io, uri.text, Side::device);
  const auto driver = open_bus(io, uri.text, Side::driver);
  const auto tap = open(io, "pty:" + name + "-tap", Side::driver);
  ASSERT_TRUE(run(io, tap->write(bytes("O\rt00111F\r"))));
  ASSERT_TRUE(run(io, read_bytes(*tap, 3)));
  EXPECT_EQ(run(io, device->read())->frame, standard(1, {0x1F}));
  EXPECT_EQ(run(io, other_device->read())->frame, standard(1, {0x1F}));

  ASSERT_TRUE(run(io, driver->write(standard(2, {}))));
  EXPECT_EQ(run(io, read_bytes(*tap, 6)).value(), bytes("t0020\r"));
  ASSERT_TRUE(run(io, other_device->write(standard(3, {}))));
  EXPECT_EQ(run(io, read_bytes(*tap, 6)).value(), bytes("t0030\r"));
  EXPECT_EQ(run(io, driver->read())->frame, standard(3, {}));
}

TEST_F(CanAuto, TheBusGoesWithItsLastDevice) {
  auto device = open_bus(io, uri.text, Side::device);
  if (has_kernel_bus()) GTEST_SKIP() << "the kernel has the bus";
  auto driver = open_bus(io, uri.text, Side::driver);
  const auto pending = start(io, driver->read());
  settle(io);
  device->close();
  ASSERT_TRUE(run_until(io, [&] { return pending->outcome.has_value(); }));
  EXPECT_FALSE(*pending->outcome);
  EXPECT_FALSE(std::filesystem::is_symlink(pty_path(name)));
  EXPECT_FALSE(std::filesystem::is_symlink(pty_path(name + "-tap")));
}

TEST(SocketCan, WithoutTheInterfaceTheReasonIsSaid) {
  asio::io_context io;
  const auto bus =
      open_frames(io.get_executor(), parse_uri("socketcan:nocan7").value(), Side::driver);
  ASSERT_FALSE(bus);
  EXPECT_THAT(bus.error().message,
              ::testing::AnyOf(::testing::StartsWith("this kernel has no SocketCAN"),
                               "there is no CAN interface nocan7: No such device"));
}

TEST(Links, OpeningAsTheOtherKindIsAnError) {
  asio::io_context io;
  EXPECT_EQ(open_bytes(io.get_executor(), parse_uri("memory-can:x").value(), Side::driver)
                .error()
                .message,
            "\"memory-can:x\" carries no bytes but CAN frames");
  EXPECT_EQ(
      open_frames(io.get_executor(), parse_uri("memory:x").value(), Side::driver).error().message,
      "\"memory:x\" carries no CAN frames but bytes");
}

}  // namespace
}  // namespace drydock::link::testing
