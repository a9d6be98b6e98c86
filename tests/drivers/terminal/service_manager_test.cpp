#include "drivers/terminal/service_manager.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <string>

namespace drydock::terminal {
namespace service_manager_test {

/// The other end, as systemd has it: sd_notify(3) says one datagram a call, KEY=VALUE.
class Systemd {
 public:
  explicit Systemd(std::string name) : name_(std::move(name)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, name_.data(), name_.size());
    if (name_[0] == '@') address.sun_path[0] = '\0';
    const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name_.size());
    bound_ = ::bind(socket_, reinterpret_cast<sockaddr*>(&address), length) == 0;
    ::setenv("NOTIFY_SOCKET", name_.c_str(), 1);
  }
  ~Systemd() {
    ::unsetenv("NOTIFY_SOCKET");
    ::close(socket_);
    if (name_[0] != '@') ::unlink(name_.c_str());
  }
  Systemd(const Systemd&) = delete;
  Systemd& operator=(const Systemd&) = delete;

  bool bound() const { return bound_; }
  /// The next datagram; empty: there is none.
  std::string heard() const {
    std::array<char, 64> text{};
    const auto size = ::recv(socket_, text.data(), text.size(), MSG_DONTWAIT);
    return size > 0 ? std::string(text.data(), static_cast<std::size_t>(size)) : std::string();
  }

 private:
  std::string name_;
  int socket_ = ::socket(AF_UNIX, SOCK_DGRAM, 0);
  bool bound_ = false;
};

class ServiceManagerAt : public testing::TestWithParam<std::string> {};

TEST_P(ServiceManagerAt, HearsADatagramForEachCall) {
  const Systemd systemd(GetParam() + std::to_string(::getpid()));
  ASSERT_TRUE(systemd.bound());
  const ServiceManager manager;
  manager.ready();
  manager.alive();
  manager.stopping();
  EXPECT_EQ(systemd.heard(), "READY=1");
  EXPECT_EQ(systemd.heard(), "WATCHDOG=1");
  EXPECT_EQ(systemd.heard(), "STOPPING=1");
  EXPECT_EQ(systemd.heard(), "");
}

INSTANTIATE_TEST_SUITE_P(APathOrAnAbstractName, ServiceManagerAt,
                         testing::Values("/tmp/drydock-notify-", "@drydock-notify-"));

TEST(ServiceManager, ThatIsNotThereIsNoTrouble) {
  ::setenv("NOTIFY_SOCKET", "/nowhere/notify", 1);
  const ServiceManager manager;
  manager.ready();
  ::unsetenv("NOTIFY_SOCKET");
}

TEST(ServiceManager, ThatStoppedReadingNeverBlocks) {
  const Systemd systemd("@drydock-notify-full-" + std::to_string(::getpid()));
  ASSERT_TRUE(systemd.bound());
  const ServiceManager manager;
  constexpr int more_than_a_socket_holds = 100'000;
  for (int i = 0; i < more_than_a_socket_holds; ++i) manager.alive();
  EXPECT_EQ(systemd.heard(), "WATCHDOG=1");
}

}  // namespace service_manager_test
}  // namespace drydock::terminal
