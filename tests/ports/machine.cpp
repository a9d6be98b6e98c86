#include "tests/ports/machine.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <filesystem>

namespace drydock::ports {
namespace {

/// The control's port can be opened only once.
int control() {
  static const int fd = ::open("/dev/qmp", O_RDWR | O_CLOEXEC);
  return fd;
}

/// The next line that is an answer; lines that tell events are passed over.
std::string answer() {
  std::string line;
  for (pollfd ready{control(), POLLIN, 0}; ::poll(&ready, 1, 5000) > 0;) {
    char c = 0;
    if (::read(control(), &c, 1) != 1) break;
    if (c != '\n') {
      line += c;
    } else if (line.find("\"return\"") != line.npos || line.find("\"error\"") != line.npos) {
      return line;
    } else {
      line.clear();
    }
  }
  return "no answer from /dev/qmp";
}

std::string ask(const std::string& command) {
  const std::string line = command + "\n";
  if (::write(control(), line.data(), line.size()) < 0) return "cannot write to /dev/qmp";
  return answer();
}

/// QMP takes no other command before this one.
std::string ask_when_ready(const std::string& command) {
  static const std::string ready = ask(R"({"execute": "qmp_capabilities"})");
  return ask(command);
}

}  // namespace

std::string unplug(const std::string& adapter) {
  return ask_when_ready(R"({"execute": "device_del", "arguments": {"id": ")" + adapter + "\"}}");
}

std::string plug(const std::string& adapter) {
  const bool first = adapter == "usb0";
  return ask_when_ready(
      R"({"execute": "device_add", "arguments": {"driver": "usb-serial", "id": ")" + adapter +
      R"(", "port": ")" + (first ? "1" : "2") + R"(", "serial": ")" + (first ? "A" : "B") +
      R"(", "chardev": ")" + adapter + "\"}}");
}

bool adapters_are_there() {
  return std::filesystem::exists("/dev/ttyUSB0") && std::filesystem::exists("/dev/ttyUSB1");
}

}  // namespace drydock::ports
