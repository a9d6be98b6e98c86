#include <gmock/gmock.h>

#include "drivers/link/can/can_interface.hpp"
#include "tests/drivers/link/running.hpp"
#include "tests/hil/survive/bench.hpp"
#include "tests/vcan/kernel_slcan.hpp"
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

class KernelSlcan : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists("/sys/module/slcan")) GTEST_SKIP() << "the kernel has no slcan";
    slcan = vcan::slcan_on_pty();
    ASSERT_FALSE(slcan->interface().empty());
  }

  std::unique_ptr<vcan::KernelSlcan> slcan;
  asio::io_context io;
};

TEST_F(KernelSlcan, TheLinkKnowsTheRateThatTheInterfaceWasSetTo) {
  ASSERT_TRUE(slcan->bring_up());
  const std::string link = "socketcan:" + slcan->interface() + "?bitrate=500000";
  EXPECT_EQ(open_bus(io, link, Side::driver)->bit_rate(), 250'000U);
  EXPECT_EQ(open_bus(io, link + "&listen=1", Side::driver)->bit_rate(), 250'000U);
}

TEST_F(KernelSlcan, OfAnAdapterThatOnlyListensIsKnownAsSuch) {
  ASSERT_TRUE(slcan->bring_up("listen-only on"));
  EXPECT_EQ(find_can_interface(slcan->interface())->listen_only, true);
  const auto bus = open_bus(io, "socketcan:" + slcan->interface() + "?listen=1", Side::driver);
  EXPECT_TRUE(run(io, bus->read()));
  EXPECT_EQ(slcan->commands(), "C\rS5\rL\r");
}

TEST_F(KernelSlcan, TellsEveryStateOfItsAdapterAndItsDriverNamesIt) {
  ASSERT_TRUE(slcan->bring_up());
  vcan::expect_every_state_is_named(*slcan);
  EXPECT_THAT(slcan->commands(), ::testing::StartsWith("C\rS5\rO\r"));
}

TEST_F(KernelSlcan, ThatIsBusOffIsBroughtBackByDownAndUp) {
  ASSERT_TRUE(slcan->bring_up());
  vcan::expect_bus_off_ends(*slcan);
}

TEST_F(KernelSlcan, WhoseAdapterIsPulledOutAndPutInAgainStreamsAsSoonAsItIsUp) {
  ASSERT_TRUE(slcan->bring_up());
  const std::string name = slcan->interface();
  fault::testing::Bench bench(fault::testing::bus_depth("socketcan:" + name + "?emulated=1"),
                              fault::testing::nobody);
  ASSERT_TRUE(bench.reaches(device::State::streaming)) << bench.health().status.view();
  slcan.reset();
  ASSERT_TRUE(bench.reaches(device::State::backing_off));
  ASSERT_TRUE(bench.until([&] {
    return bench.lines.back().find("there is no CAN interface " + name) != std::string::npos;
  })) << bench.lines.back();
  slcan = vcan::slcan_on_pty();
  ASSERT_EQ(slcan->interface(), name);
  ASSERT_TRUE(slcan->bring_up());
  ASSERT_TRUE(bench.reaches(device::State::streaming)) << bench.health().status.view();
  EXPECT_TRUE(bench.hears_again());
}

}  // namespace
}  // namespace drydock::link::testing
