// The latency that an inline proxy adds between ptys, and between slcan adapters on them, compared
// with one bare pty.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>

#include <string>

#include "tests/bench/proxied_hop.hpp"

namespace {

using namespace drydock::bench;

int open_raw(const std::string& path) {
  const int fd = open(path.c_str(), O_RDWR | O_NOCTTY);
  termios raw{};
  if (fd < 0 || tcgetattr(fd, &raw) != 0) return -1;
  cfmakeraw(&raw);
  tcsetattr(fd, TCSANOW, &raw);
  return fd;
}

void bytes_over_ptys(std::size_t size) {
  const Pty bare, device;
  const std::string virt = "/tmp/drydock-proxy-bench-" + std::to_string(getpid());
  Running proxy("serial:" + std::string(device.name) + "?baud=115200", "pty:" + virt);
  const int drivers = open_raw(virt);
  compare(fmt::format("{} bytes", size).c_str(), bare.master, bare.slave, device.master, drivers,
          std::string(size, 'x'));
  print_own(proxy);
  close(drivers);
}

/// The bare line carries the same text: an slcan adapter is a pty too.
void frames_over_slcan() {
  const Pty bare, device;
  const std::string virt = "/tmp/drydock-proxy-bench-can-" + std::to_string(getpid());
  Running proxy("slcan:" + std::string(device.name), "slcan:pty:" + virt);
  const int drivers = open_raw(virt);
  say(drivers, "\rC\rS5\rO\r");
  std::this_thread::sleep_for(10 * period);
  char answers[64];
  while (wait_readable(drivers, 50) && read(drivers, answers, sizeof answers) > 0) {
  }
  compare("slcan frame", bare.master, bare.slave, device.master, drivers,
          "T0CF02A8080102030405060708\r");
  print_own(proxy);
  close(drivers);
}

}  // namespace

int main() {
  fmt::print("nice {}\n", getpriority(PRIO_PROCESS, 0));
  for (const std::size_t size : {1, 40, 1000}) bytes_over_ptys(size);
  frames_over_slcan();
}
