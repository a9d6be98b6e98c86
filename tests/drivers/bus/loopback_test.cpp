#include <gtest/gtest.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <cstdlib>
#include <filesystem>

#include "tests/drivers/bus/bus_fixture.hpp"

namespace drydock::bus::test {
namespace loopback_test {

struct Reach {
  int on_loopback = 0, elsewhere = 0;  ///< bound internet sockets of this process
};

bool is_loopback(const sockaddr_in& address) {
  return (ntohl(address.sin_addr.s_addr) >> 24) == 127;
}

Reach reach_of_this_process() {
  Reach reach;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    const int descriptor = std::stoi(entry.path().filename().string());
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    if (::getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size) != 0) continue;
    if (address.ss_family != AF_INET && address.ss_family != AF_INET6) continue;
    std::array<char, IFNAMSIZ> device{};
    socklen_t length = device.size();
    ::getsockopt(descriptor, SOL_SOCKET, SO_BINDTODEVICE, device.data(), &length);
    const bool kept = std::string_view(device.data()) == "lo" ||
                      (address.ss_family == AF_INET &&
                       is_loopback(reinterpret_cast<const sockaddr_in&>(address)));
    ++(kept ? reach.on_loopback : reach.elsewhere);
  }
  return reach;
}

TEST(BusReach, NothingListensBeyondTheLoopbackInterface) {
  if (std::getenv("CYCLONEDDS_URI") != nullptr) GTEST_SKIP() << "configured from outside";
  const Reach before = reach_of_this_process();
  const Participant participant(test_domain());
  const Publisher publisher(participant, all_devices());
  const Subscriber subscriber(participant, all_devices());
  const Participant second(test_domain());
  const Reach with = reach_of_this_process();
  EXPECT_EQ(with.elsewhere, before.elsewhere);
  EXPECT_GE(with.on_loopback, before.on_loopback + 2) << "discovery and data";
}

TEST(BusReach, AProcessIsInADomainByOneInterfaceOnly) {
  const Participant participant(test_domain());
  EXPECT_THROW(Participant(test_domain(), "eth-of-nobody"), Error);
}

TEST(BusReach, AnInterfaceThatIsNotThereIsAnError) {
  EXPECT_THROW(Participant(test_domain() + 90, "eth-of-nobody"), Error);
}

}  // namespace loopback_test
}  // namespace drydock::bus::test
