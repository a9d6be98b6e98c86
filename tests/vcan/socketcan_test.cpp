#include <fcntl.h>
#include <gmock/gmock.h>
#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/socket.h>

#include <fstream>

#include "drivers/link/can/can_interface.hpp"
#include "drivers/link/descriptor.hpp"
#include "tests/drivers/link/running.hpp"
#include "tests/vcan/process.hpp"

/// Our SocketCAN link with the kernel and can-utils.
namespace drydock::link::testing {
namespace {

using ::testing::HasSubstr;
using vcan::Process;
using wire::CanFrame;

CanFrame frame(std::uint32_t id, bool extended, std::initializer_list<std::uint8_t> data) {
  CanFrame made;
  made.id = id;
  made.extended = extended;
  made.size = static_cast<std::uint8_t>(data.size());
  std::copy(data.begin(), data.end(), made.data.begin());
  return made;
}

class SocketCan : public ::testing::Test {
 protected:
  std::unique_ptr<FrameLink> open_interface(const std::string& query = "") {
    return open_bus(io, "socketcan:" + interface + query, Side::driver);
  }

  std::string interface = vcan::interface();
  asio::io_context io;
};

TEST_F(SocketCan, CandumpSeesWhatWeWriteByteForByte) {
  const auto bus = open_interface("?fd=1");
  const int before = vcan::receiver_count(interface);
  Process candump({"candump", "-L", interface});
  ASSERT_TRUE(vcan::wait_for_receivers(interface, before + 1));

  CanFrame remote = frame(0x7FF, false, {});
  remote.remote = true;
  CanFrame fd = frame(0x18FF0001, true, {});
  fd.fd = fd.bit_rate_switch = true;
  fd.size = 64;
  for (std::size_t i = 0; i < 64; ++i) fd.data[i] = static_cast<std::uint8_t>(0xC0 + i);
  for (const CanFrame& sent : {frame(0x123, false, {0x11, 0x22, 0x33}), frame(0x123, true, {}),
                               frame(0x09F11201, true, {0xFF, 0, 1, 2, 3, 4, 5, 0xFE}), remote, fd})
    ASSERT_TRUE(run(io, bus->write(sent)));

  const std::string seen = candump.output_until("\n", 5);
  EXPECT_THAT(seen, HasSubstr(" " + interface + " 123#112233\n"));
  EXPECT_THAT(seen, HasSubstr(" " + interface + " 00000123#\n"));
  EXPECT_THAT(seen, HasSubstr(" " + interface + " 09F11201#FF000102030405FE\n"));
  EXPECT_THAT(seen, HasSubstr(" " + interface + " 7FF#R\n"));
  // Since Linux 6.1 the kernel adds its own flag 4 (CANFD_FDF) to our flag 1 (bit rate switch).
  const std::string data =
      "C0C1C2C3C4C5C6C7C8C9CACBCCCDCECFD0D1D2D3D4D5D6D7D8D9DADBDCDDDEDF"
      "E0E1E2E3E4E5E6E7E8E9EAEBECEDEEEFF0F1F2F3F4F5F6F7F8F9FAFBFCFDFEFF\n";
  EXPECT_THAT(seen,
              ::testing::AnyOf(HasSubstr(" 18FF0001##1" + data), HasSubstr(" 18FF0001##5" + data)));
}

TEST_F(SocketCan, CansendArrivesWithTheKernelsStamp) {
  const auto bus = open_interface();
  const Stamp before = now();
  ASSERT_EQ(vcan::run_program({"cansend", interface, "09F11201#0102030405060708"}), 0);
  ASSERT_EQ(vcan::run_program({"cansend", interface, "7AB#R"}), 0);
  const Stamp after = now();

  const auto first = run(io, bus->read());
  ASSERT_TRUE(first);
  EXPECT_EQ(first->frame, frame(0x09F11201, true, {1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_FALSE(first->own);
  // The frame is read after cansend has ended. A stamp before that time is the kernel's, not ours.
  EXPECT_GE(first->at, before);
  EXPECT_LE(first->at, after);
  const auto second = run(io, bus->read());
  EXPECT_TRUE(second->frame.remote);
  EXPECT_EQ(second->frame.id, 0x7ABU);
}

TEST_F(SocketCan, CanplayerReplaysALogIntoTheLink) {
  const auto bus = open_interface();
  const Folder folder;
  const std::string log = folder.file("dive.log");
  {
    std::ofstream file(log);
    for (int i = 0; i < 50; ++i)
      file << "(1700000000." << 100000 + 2000 * i << ") " << interface << " 1CFF00FF#" << std::hex
           << std::uppercase << 0x10 + i << std::dec << "\n";
  }
  Process player({"canplayer", "-I", log});
  for (int i = 0; i < 50; ++i) {
    const auto received = run(io, bus->read());
    ASSERT_TRUE(received) << i;
    EXPECT_EQ(received->frame, frame(0x1CFF00FF, true, {static_cast<std::uint8_t>(0x10 + i)}));
  }
  EXPECT_EQ(player.wait(), 0);
}

/// Sends the same as canerrsim of can-utils: a frame with the error flag. Every socket with an
/// error filter receives it as if the controller had reported it.
void send_error(const std::string& interface, canid_t error_class, std::uint8_t controller) {
  const Descriptor socket(::socket(PF_CAN, SOCK_RAW, CAN_RAW));
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = static_cast<int>(::if_nametoindex(interface.c_str()));
  ASSERT_EQ(::bind(socket.get(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  can_frame error{};
  error.can_id = CAN_ERR_FLAG | error_class;
  error.len = CAN_ERR_DLC;
  error.data[1] = controller;
  ASSERT_EQ(::write(socket.get(), &error, sizeof error), static_cast<ssize_t>(sizeof error));
}

TEST_F(SocketCan, ErrorFramesComeThroughAsErrors) {
  const auto bus = open_interface();
  send_error(interface, CAN_ERR_CRTL, CAN_ERR_CRTL_RX_PASSIVE);
  send_error(interface, CAN_ERR_BUSOFF, 0);
  const auto passive = run(io, bus->read());
  ASSERT_TRUE(passive);
  EXPECT_TRUE(passive->frame.error);
  EXPECT_FALSE(passive->frame.extended);
  EXPECT_EQ(passive->frame.id, CAN_ERR_CRTL);
  EXPECT_EQ(passive->frame.data[1], CAN_ERR_CRTL_RX_PASSIVE);
  EXPECT_EQ(run(io, bus->read())->frame.id, CAN_ERR_BUSOFF);
}

TEST_F(SocketCan, OwnFramesComeBackOnlyOnRequestAndMarked) {
  const auto quiet = open_interface();
  const auto echoing = open_interface("?echo=1");
  ASSERT_TRUE(run(io, quiet->write(frame(1, false, {}))));
  ASSERT_TRUE(run(io, echoing->write(frame(2, false, {}))));
  const auto from_other = run(io, echoing->read());
  EXPECT_EQ(from_other->frame.id, 1U);
  EXPECT_FALSE(from_other->own);
  const auto own = run(io, echoing->read());
  EXPECT_EQ(own->frame.id, 2U);
  EXPECT_TRUE(own->own);
  EXPECT_EQ(run(io, quiet->read())->frame.id, 2U);
}

TEST_F(SocketCan, CanFdArrivesOnlyWhereItIsWanted) {
  const auto classic = open_interface();
  const auto fd = open_interface("?fd=1");
  ASSERT_EQ(vcan::run_program({"cansend", interface, "123##1000102030405060708090A0B"}), 0);
  ASSERT_EQ(vcan::run_program({"cansend", interface, "124#"}), 0);
  const auto received = run(io, fd->read());
  ASSERT_TRUE(received);
  EXPECT_TRUE(received->frame.fd);
  EXPECT_TRUE(received->frame.bit_rate_switch);
  EXPECT_EQ(received->frame.size, 12);
  EXPECT_EQ(received->frame.data[11], 0x0B);
  EXPECT_EQ(run(io, classic->read())->frame.id, 0x124U);
}

TEST_F(SocketCan, FramesLostInTheQueueAreCounted) {
  const auto slow = open_interface();
  const auto sender = open_interface();
  constexpr unsigned sent = 20'000;
  for (unsigned i = 0; i < sent; ++i)
    ASSERT_TRUE(run(io, sender->write(frame(i % 0x800, false, {1}))));

  unsigned received = 0;
  auto reading = start(io, slow->read());
  while (run_until(
      io, [&] { return reading->outcome.has_value(); }, 200ms)) {
    ASSERT_TRUE(*reading->outcome);
    ++received;
    reading = start(io, slow->read());
  }
  ASSERT_LT(received, sent) << "the queue was never full";

  // The kernel reports the count with the next frame that fits into the queue.
  ASSERT_TRUE(run(io, sender->write(frame(0x7FF, false, {}))));
  ASSERT_TRUE(run_until(io, [&] { return reading->outcome.has_value(); }));
  EXPECT_EQ(reading->outcome->value().frame.id, 0x7FFU);
  EXPECT_EQ(slow->dropped(), sent - received);
}

// 250 kbit/s are 5319 of the shortest frames a second (47 bits, ISO 11898-1).
TEST_F(SocketCan, OneSecondOfAFullBusWaitsInTheQueue) {
  if (::geteuid() != 0) GTEST_SKIP() << "a queue beyond net.core.rmem_max needs CAP_NET_ADMIN";
  const auto slow = open_interface();
  const auto sender = open_interface();
  constexpr unsigned sent = 5319;
  for (unsigned i = 0; i < sent; ++i)
    ASSERT_TRUE(run(io, sender->write(frame(i % 0x800, false, {}))));
  for (unsigned i = 0; i < sent; ++i) ASSERT_EQ(run(io, slow->read())->frame.id, i % 0x800);
  EXPECT_EQ(slow->dropped(), 0U);
}

TEST_F(SocketCan, WhoseStampsAreUsedIsSaid) {
  const auto bus = open_interface();
  ASSERT_EQ(vcan::run_program({"cansend", interface, "001#"}), 0);
  ASSERT_TRUE(run(io, bus->read()));
  EXPECT_EQ(bus->note(), "stamps of the kernel");
  EXPECT_EQ(open_interface("?listen=1")->note(), "stamps of the kernel; nothing is sent");
}

TEST_F(SocketCan, AListeningLinkNeverSends) {
  const auto listening = open_interface("?listen=1");
  const auto other = open_interface();
  EXPECT_FALSE(run(io, listening->write(frame(1, false, {}))));
  ASSERT_EQ(vcan::run_program({"cansend", interface, "002#"}), 0);
  EXPECT_EQ(run(io, other->read())->frame.id, 2U);
}

/// A second interface that the test may take down. Needs CAP_NET_ADMIN.
class OwnInterface : public SocketCan {
 protected:
  void SetUp() override {
    interface = "vdrydock" + std::to_string(::getpid() % 1000);
    const ErrorCode error = create_vcan(interface);
    if (error == boost::system::errc::operation_not_permitted)
      GTEST_SKIP() << "making an interface needs CAP_NET_ADMIN";
    ASSERT_FALSE(error) << error.message();
  }
  void TearDown() override { vcan::run_program({"ip", "link", "delete", interface}); }
};

TEST_F(OwnInterface, GoingDownIsAClearErrorAndReopeningWorks) {
  const auto bus = open_interface();
  const auto pending = start(io, bus->read());
  settle(io);
  ASSERT_FALSE(set_interface_up(interface, false));
  ASSERT_TRUE(run_until(io, [&] { return pending->outcome.has_value(); }));
  EXPECT_EQ(pending->outcome->error(), boost::system::errc::network_down);
  EXPECT_EQ(run(io, bus->write(frame(1, false, {}))).error(), boost::system::errc::network_down);

  const auto refused =
      open_frames(io.get_executor(), parse_uri("socketcan:" + interface).value(), Side::driver);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, interface + " is down: sudo ip link set " + interface + " up");

  ASSERT_FALSE(set_interface_up(interface, true));
  const auto again = open_interface();
  ASSERT_EQ(vcan::run_program({"cansend", interface, "001#"}), 0);
  EXPECT_EQ(run(io, again->read())->frame.id, 1U);
}

TEST_F(OwnInterface, VanishingEndsTheRead) {
  const auto bus = open_interface();
  const auto pending = start(io, bus->read());
  settle(io);
  ASSERT_EQ(vcan::run_program({"ip", "link", "delete", interface}), 0);
  ASSERT_TRUE(run_until(io, [&] { return pending->outcome.has_value(); }));
  EXPECT_FALSE(*pending->outcome);
}

TEST_F(OwnInterface, CanAutoTakesTheKernelsBusAndSaysSo) {
  const Uri uri = parse_uri("can:auto?name=" + interface).value();
  EXPECT_EQ(can_auto_level(uri), interface + " of the kernel");
  const auto device = open_bus(io, uri.text, Side::device);
  const auto driver = open_bus(io, uri.text, Side::driver);
  EXPECT_EQ(driver->provenance(), Provenance::emulated);
  ASSERT_TRUE(run(io, device->write(frame(0x181, false, {7}))));
  EXPECT_EQ(run(io, driver->read())->frame, frame(0x181, false, {7}));
}

TEST_F(OwnInterface, CanAutoMakesTheInterfaceOnTheDeviceSideOnly) {
  vcan::run_program({"ip", "link", "delete", interface});
  const Uri uri = parse_uri("can:auto?name=" + interface).value();
  EXPECT_FALSE(open_frames(io.get_executor(), uri, Side::driver));
  const auto device = open_bus(io, uri.text, Side::device);
  EXPECT_TRUE(find_can_interface(interface).value().up);
  EXPECT_EQ(find_can_interface(interface).value().mtu, CANFD_MTU);
  EXPECT_EQ(can_auto_level(uri), interface + " of the kernel");
}

}  // namespace
}  // namespace drydock::link::testing
