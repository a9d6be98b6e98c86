// Which sockets of a running program can be reached from the network.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <net/if.h>
#include <netinet/in.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "tests/own_domain.hpp"

namespace sockets_test {

/// The demo rig in real time with its live page. It runs until the end of the test.
class RunningDemo {
 public:
  RunningDemo() {
    auto name = (std::filesystem::temp_directory_path() / "drydock-test-XXXXXX").string();
    links_ = mkdtemp(name.data());
    const std::string links = "XDG_RUNTIME_DIR=" + links_.string(),
                      domain = "ROS_DOMAIN_ID=" + std::to_string(drydock::test::own_domain());
    std::array environment{const_cast<char*>(links.c_str()), const_cast<char*>(domain.c_str()),
                           static_cast<char*>(nullptr)};
    std::vector<std::string> words{
        DRYDOCK_PROGRAM, "run", DRYDOCK_SOURCE_DIR "/rig_config/rigs/demo.toml", "--for", "60s",
        "--serve",       "0"};
    std::vector<char*> arguments;
    for (auto& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t quiet;
    posix_spawn_file_actions_init(&quiet);
    posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    const int error =
        posix_spawn(&pid_, DRYDOCK_PROGRAM, &quiet, nullptr, arguments.data(), environment.data());
    posix_spawn_file_actions_destroy(&quiet);
    if (error != 0) throw std::system_error(error, std::generic_category());
    pidfd_ = static_cast<int>(syscall(SYS_pidfd_open, pid_, 0));
  }
  ~RunningDemo() {
    kill(pid_, SIGTERM);
    waitpid(pid_, nullptr, 0);
    close(pidfd_);
    std::filesystem::remove_all(links_);
  }
  RunningDemo(const RunningDemo&) = delete;
  RunningDemo& operator=(const RunningDemo&) = delete;

  std::filesystem::path descriptors() const { return "/proc/" + std::to_string(pid_) + "/fd"; }
  /// A copy of the program's descriptor; below 0: not allowed, or closed.
  int borrow(int descriptor) const {
    return static_cast<int>(syscall(SYS_pidfd_getfd, pidfd_, descriptor, 0));
  }

 private:
  std::filesystem::path links_;
  pid_t pid_ = 0;
  int pidfd_ = -1;
};

bool on_loopback(int socket, const sockaddr_storage& address) {
  std::array<char, IFNAMSIZ> device{};
  socklen_t length = device.size();
  getsockopt(socket, SOL_SOCKET, SO_BINDTODEVICE, device.data(), &length);
  if (std::string_view(device.data()) == "lo") return true;
  if (address.ss_family == AF_INET)
    return ntohl(reinterpret_cast<const sockaddr_in&>(address).sin_addr.s_addr) >> 24 == 127;
  const auto& six = reinterpret_cast<const sockaddr_in6&>(address).sin6_addr;
  return IN6_IS_ADDR_LOOPBACK(&six);
}

struct Found {
  int streams = 0, datagrams = 0, beyond_loopback = 0;
};

/// Internet sockets that are bound to a port. Packet and raw sockets count as reachable.
Found sockets_of(const RunningDemo& demo) {
  Found found;
  std::error_code gone;
  for (const auto& entry : std::filesystem::directory_iterator(demo.descriptors(), gone)) {
    const int socket = demo.borrow(std::stoi(entry.path().filename().string()));
    sockaddr_storage address{};
    socklen_t size = sizeof address, type_size = sizeof(int);
    int type = 0;
    const bool is_socket = socket >= 0 &&
                           getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) == 0 &&
                           getsockopt(socket, SOL_SOCKET, SO_TYPE, &type, &type_size) == 0;
    const bool internet = address.ss_family == AF_INET || address.ss_family == AF_INET6;
    if (is_socket && (internet || address.ss_family == AF_PACKET)) {
      ++(type == SOCK_STREAM ? found.streams : found.datagrams);
      found.beyond_loopback += !internet || !on_loopback(socket, address);
    }
    if (socket >= 0) close(socket);
  }
  return found;
}

TEST(Sockets, OfARunningDemoRigAreAllOnTheLoopbackInterface) {
  const RunningDemo demo;
  const int own = demo.borrow(0);
  if (own < 0 && (errno == EPERM || errno == ENOSYS))
    GTEST_SKIP() << "this kernel or container does not let a parent look at its child's sockets";
  close(own);
  Found found;
  // The page has one socket. DDS receives on two and sends on one, and opens them before the
  // program can bind them to the interface, so the first look can fall between the two.
  const auto up = [&found] {
    return found.streams >= 1 && found.datagrams >= 3 && found.beyond_loopback == 0;
  };
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!up() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    found = sockets_of(demo);
  }
  EXPECT_GE(found.streams, 1);
  EXPECT_GE(found.datagrams, 3);
  EXPECT_EQ(found.beyond_loopback, 0);
}

}  // namespace sockets_test
