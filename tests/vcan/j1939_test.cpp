#include <gmock/gmock.h>
#include <linux/can/j1939.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <functional>
#include <numeric>

#include "drivers/link/can/kernel_frame.hpp"
#include "drivers/wire/j1939/j1939_address_claim.hpp"
#include "drivers/wire/j1939/j1939_transport_receiver.hpp"
#include "drivers/wire/j1939/j1939_transport_sender.hpp"
#include "tests/vcan/process.hpp"

/// Tests against Linux's own J1939 stack (can-j1939) and can-utils' j1939acd on the same bus.
namespace drydock::wire::j1939 {
namespace {

using Data = std::vector<std::uint8_t>;
using Time = std::chrono::nanoseconds;
using namespace std::chrono_literals;

constexpr std::uint8_t our_address = 0x90, kernel_address = 0x80;
constexpr std::uint32_t test_pgn = 0x12300;

Time now() { return std::chrono::steady_clock::now().time_since_epoch(); }

Data counting(std::size_t size) {
  Data data(size);
  std::iota(data.begin(), data.end(), std::uint8_t{1});
  return data;
}

/// A socket that is bound to the interface. The destructor closes it.
struct Socket {
  Socket(int type, int protocol) : fd(::socket(PF_CAN, type | SOCK_NONBLOCK, protocol)) {}
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  ~Socket() { ::close(fd); }
  bool bind_to(sockaddr_can address) const {
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(::if_nametoindex(vcan::interface().c_str()));
    return ::bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  }
  const int fd;
};

/// Our end of the bus: raw frames.
struct OurBus {
  Socket socket{SOCK_RAW, CAN_RAW};

  void send(const std::optional<CanFrame>& frame) const {
    if (!frame) return;
    const auto kernel = link::to_kernel(*frame);
    ASSERT_EQ(::write(socket.fd, &kernel.frame, kernel.size), static_cast<ssize_t>(kernel.size));
  }

  std::optional<CanFrame> next() const {
    link::KernelFrame kernel;
    const auto size = ::read(socket.fd, &kernel.frame, sizeof kernel.frame);
    if (size != CAN_MTU) return std::nullopt;
    return link::from_kernel(kernel);
  }
};

/// Passes on frames and time until `done` is true, at most ten seconds.
void run(const OurBus& bus, const std::function<void(const CanFrame&)>& hear,
         const std::function<void()>& tick, const std::function<bool()>& done) {
  for (const Time end = now() + 10s; !done() && now() < end;) {
    pollfd waiting{bus.socket.fd, POLLIN, 0};
    ::poll(&waiting, 1, 1);
    while (const auto frame = bus.next()) hear(*frame);
    tick();
  }
  EXPECT_TRUE(done());
}

class KernelJ1939 : public ::testing::Test {
 protected:
  void SetUp() override {
    if (kernel.fd < 0) GTEST_SKIP() << "this kernel has no J1939 sockets";
    ASSERT_TRUE(bus.socket.bind_to({}));
    sockaddr_can address{};
    address.can_addr.j1939 = {J1939_NO_NAME, J1939_NO_PGN, kernel_address};
    ASSERT_TRUE(kernel.bind_to(address));
    const int yes = 1;
    ASSERT_EQ(::setsockopt(kernel.fd, SOL_SOCKET, SO_BROADCAST, &yes, sizeof yes), 0);
  }

  /// The kernel sends `data` to that address. Returns the message that our receiver assembles.
  Data from_kernel(std::uint8_t to, const Data& data) {
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_addr.j1939 = {J1939_NO_NAME, test_pgn, to};
    EXPECT_EQ(::sendto(kernel.fd, data.data(), data.size(), 0,
                       reinterpret_cast<const sockaddr*>(&address), sizeof address),
              static_cast<ssize_t>(data.size()));
    TransportReceiver receiver;
    receiver.set_address(our_address);
    Data got;
    run(
        bus,
        [&](const CanFrame& frame) {
          const auto id = identify(frame);
          if (!id) return;
          auto result = receiver.receive(*id, frame.payload(), now());
          bus.send(result.reply);
          if (!result.message) return;
          EXPECT_EQ(result.message->id.pgn, test_pgn);
          EXPECT_EQ(result.message->id.source, kernel_address);
          got.assign(result.message->data.begin(), result.message->data.end());
        },
        [] {}, [&] { return !got.empty(); });
    return got;
  }

  /// Our sender sends `data` to that address. Returns the message that the kernel's socket
  /// receives.
  Data to_kernel(std::uint8_t to, const Data& data) {
    TransportSender sender;
    bus.send(sender.send({6, test_pgn, to, our_address}, data, now()));
    Data got(2000);
    ssize_t size = -1;
    run(
        bus,
        [&](const CanFrame& frame) {
          const auto id = identify(frame);
          if (id && id->source == kernel_address) {
            bus.send(sender.receive(*id, frame.payload(), now()));
          }
        },
        [&] {
          while (sender.deadline() && *sender.deadline() <= now()) bus.send(sender.tick(now()));
          if (size < 0) size = ::recv(kernel.fd, got.data(), got.size(), 0);
        },
        [&] { return size >= 0 && !sender.busy(); });
    EXPECT_EQ(sender.outcome(), TransportSender::Outcome::sent);
    got.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    return got;
  }

  OurBus bus;
  Socket kernel{SOCK_DGRAM, CAN_J1939};
};

TEST_F(KernelJ1939, BroadcastsOfTheKernelArriveWhole) {
  EXPECT_EQ(from_kernel(global_address, counting(100)), counting(100));
}

TEST_F(KernelJ1939, ConnectionsOfTheKernelArriveWholeUpToTheLongest) {
  for (const std::size_t size : {9, 300, 1785}) {
    EXPECT_EQ(from_kernel(our_address, counting(size)), counting(size));
  }
}

TEST_F(KernelJ1939, TheKernelPutsOurBroadcastTogether) {
  EXPECT_EQ(to_kernel(global_address, counting(100)), counting(100));
}

TEST_F(KernelJ1939, TheKernelPutsOurConnectionsTogetherUpToTheLongest) {
  for (const std::size_t size : {9, 300, 1785}) {
    EXPECT_EQ(to_kernel(kernel_address, counting(size)), counting(size));
  }
}

/// j1939acd holds 0x80 with a NAME that may move; then our node claims that address.
std::optional<std::uint8_t> contend(const OurBus& bus, std::uint64_t our_name) {
  constexpr std::uint64_t its_name = 0x8000000000001000;
  vcan::Process daemon(
      {"j1939acd", "-r", "128-130", "-a", "128", "8000000000001000", vcan::interface()});
  std::optional<std::uint8_t> its_address;
  AddressClaim ours(our_name, 0x80, {0x80, 0x90});
  bool started = false;
  const auto settled = [&] { return started && its_address && ours.address(); };
  const auto hear = [&](const CanFrame& frame) {
    const auto id = identify(frame);
    const auto claim = id ? decode_address_claimed(*id, frame.payload()) : std::nullopt;
    if (claim && claim->name == its_name) {
      its_address = claim->source;
      if (!started) bus.send(ours.start(now()));
      started = true;
    }
    bus.send(ours.receive(frame, now()));
  };
  const auto tick = [&] {
    while (ours.deadline() && *ours.deadline() <= now()) bus.send(ours.tick(now()));
  };
  run(bus, hear, tick, settled);
  EXPECT_NE(ours.address(), its_address);
  return ours.address();
}

TEST_F(KernelJ1939, AgainstJ1939acdTheLowerNameKeepsTheAddress) {
  EXPECT_EQ(contend(bus, 0x8000000000000001), 0x80);
}

TEST_F(KernelJ1939, AgainstJ1939acdTheHigherNameMovesOn) {
  const auto address = contend(bus, 0x8000000000002000);
  ASSERT_TRUE(address);
  EXPECT_NE(*address, 0x80);
}

}  // namespace
}  // namespace drydock::wire::j1939
