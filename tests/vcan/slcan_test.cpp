#include <fcntl.h>
#include <gmock/gmock.h>
#include <net/if.h>
#include <sys/ioctl.h>

#include <thread>

#include "drivers/link/can/can_interface.hpp"
#include "drivers/link/descriptor.hpp"
#include "tests/drivers/link/running.hpp"
#include "tests/vcan/process.hpp"

/// Our emulated slcan adapter with slcand of can-utils and the kernel's slcan driver.
namespace drydock::link::testing {
namespace {

using vcan::Process;

bool is_up(const std::string& interface) {
  const auto found = find_can_interface(interface);
  return found && found->up;
}

TEST(SlcanAdapter, SlcandMakesACanInterfaceOfIt) {
  if (!std::filesystem::exists("/sys/module/slcan")) GTEST_SKIP() << "the kernel has no slcan";
  const Folder folder;
  const std::string path = folder.file("adapter");
  asio::io_context io;
  const auto adapter = open_bus(io, "slcan:pty:" + path, Side::device);
  Process slcand({"slcand", "-F", "-o", "-s5", std::filesystem::read_symlink(path), "slc0"});
  const auto end = std::chrono::steady_clock::now() + 5s;
  while (!is_up("slc0") && std::chrono::steady_clock::now() < end) {
    settle(io);
    vcan::run_program({"ip", "link", "set", "slc0", "up"});
  }
  ASSERT_TRUE(is_up("slc0")) << slcand.output_until("\n");
  settle(io);

  ASSERT_EQ(vcan::run_program({"cansend", "slc0", "09F11201#0102030405060708"}), 0);
  const auto received = run(io, adapter->read());
  ASSERT_TRUE(received);
  EXPECT_EQ(received->frame.id, 0x09F11201U);
  EXPECT_TRUE(received->frame.extended);
  EXPECT_THAT(received->frame.payload(), ::testing::ElementsAre(1, 2, 3, 4, 5, 6, 7, 8));

  Process candump({"candump", "-L", "-n", "1", "slc0"});
  ASSERT_TRUE(vcan::wait_for_receivers("slc0", 1));
  wire::CanFrame sent;
  sent.id = 0x123;
  sent.size = 2;
  sent.data = {0xAB, 0xCD};
  ASSERT_TRUE(run(io, adapter->write(sent)));
  settle(io);
  EXPECT_THAT(candump.output_until("\n"), ::testing::HasSubstr(" slc0 123#ABCD\n"));
}

/// The kernel's slcan driver on a pty: a CAN interface with a bit rate, without hardware.
class KernelSlcan : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists("/sys/module/slcan")) GTEST_SKIP() << "the kernel has no slcan";
    master = Descriptor(::posix_openpt(O_RDWR | O_NOCTTY));
    ASSERT_EQ(::grantpt(master.get()), 0);
    ASSERT_EQ(::unlockpt(master.get()), 0);
    slave = Descriptor(::open(::ptsname(master.get()), O_RDWR | O_NOCTTY));
    const int slcan_discipline = 17;
    ASSERT_EQ(::ioctl(slave.get(), TIOCSETD, &slcan_discipline), 0);
    std::array<char, IFNAMSIZ> got{};
    ASSERT_EQ(::ioctl(slave.get(), SIOCGIFNAME, got.data()), 0);
    name = got.data();
    // The kernel waits until somebody has read its command.
    adapter = std::thread([this] {
      std::array<char, 64> commands{};
      while (::read(master.get(), commands.data(), commands.size()) > 0) {
      }
    });
  }
  void TearDown() override {
    slave = Descriptor();  // the adapter then reads an error
    if (adapter.joinable()) adapter.join();
  }

  Descriptor master, slave;
  std::thread adapter;
  std::string name;
  asio::io_context io;
};

TEST_F(KernelSlcan, TheLinkKnowsTheRateThatTheInterfaceWasSetTo) {
  ASSERT_EQ(
      vcan::run_program({"ip", "link", "set", name, "up", "type", "can", "bitrate", "500000"}), 0);
  EXPECT_EQ(open_bus(io, "socketcan:" + name, Side::driver)->bit_rate(), 500'000U);
  EXPECT_EQ(open_bus(io, "socketcan:" + name + "?listen=1", Side::driver)->bit_rate(), 500'000U);
}

}  // namespace
}  // namespace drydock::link::testing
