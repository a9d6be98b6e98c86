// The latency that an inline proxy adds between two CAN interfaces, compared with one bare
// interface.
// usage: proxy_can_bench REAL VIRTUAL BARE     three interfaces that are up, such as vcan0 vcan1
// vcan2
#include <linux/can.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include <cstring>

#include "tests/bench/proxied_hop.hpp"

namespace {

using namespace drydock::bench;

/// A raw CAN socket, as other programs use it; it is not this program's link.
class Socket {
 public:
  explicit Socket(const char* interface) : fd(socket(PF_CAN, SOCK_RAW, CAN_RAW)) {
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(if_nametoindex(interface));
    if (address.can_ifindex != 0 &&
        bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
      return;
    fmt::print(stderr, "{}: no CAN interface that is up\n", interface);
    std::exit(1);
  }
  ~Socket() { close(fd); }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  const int fd;
};

/// Eight bytes with an extended identifier, in the kernel's layout.
std::string frame_in_memory() {
  can_frame frame{};
  frame.can_id = 0x0CF02A80 | CAN_EFF_FLAG;
  frame.can_dlc = 8;
  std::memset(frame.data, 0x5A, sizeof frame.data);
  return {reinterpret_cast<const char*>(&frame), sizeof frame};
}

/// Measures how late a sleeping thread wakes, like the thread that sends each frame. That is the
/// precision of the machine's timers.
void print_timer() {
  std::vector<double> late;
  for (int i = 0; i < 500; ++i) {
    const auto due = Clock::now() + period;
    std::this_thread::sleep_until(due);
    late.push_back(std::chrono::duration<double, std::micro>(Clock::now() - due).count());
  }
  const auto p = percentiles_of(late);
  fmt::print("{:24} late p50 {:.0f} p99 {:.0f} us\n", "a bare timer", p.p50, p.p99);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 4) {
    fmt::print(stderr, "usage: proxy_can_bench REAL VIRTUAL BARE\n");
    return 2;
  }
  const char *real = arguments[1], *virt = arguments[2], *bare = arguments[3];
  fmt::print("nice {}\n", getpriority(PRIO_PROCESS, 0));
  print_timer();
  const Socket bare_in(bare), bare_out(bare), device(real), drivers(virt);
  Running proxy("socketcan:" + std::string(real), "socketcan:" + std::string(virt));
  compare("CAN frame", bare_in.fd, bare_out.fd, device.fd, drivers.fd, frame_in_memory());
  print_own(proxy);
}
