#include "drivers/bus/loopback_sockets.hpp"

#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace drydock::bus {

namespace {

bool receives_from_everywhere(int descriptor) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (::getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size) != 0) return false;
  if (address.ss_family == AF_INET)
    return reinterpret_cast<const sockaddr_in&>(address).sin_addr.s_addr == INADDR_ANY;
  return address.ss_family == AF_INET6 &&
         IN6_IS_ADDR_UNSPECIFIED(&reinterpret_cast<const sockaddr_in6&>(address).sin6_addr);
}

/// Sockets of this process that are bound to all interfaces.
std::set<int> open_sockets() {
  std::set<int> sockets;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    const int descriptor = std::stoi(entry.path().filename().string());
    if (receives_from_everywhere(descriptor)) sockets.insert(descriptor);
  }
  return sockets;
}

}  // namespace

LoopbackSockets::LoopbackSockets() : before_(open_sockets()) {}

void LoopbackSockets::keep_new_ones_to_loopback() const {
  constexpr std::string_view loopback = "lo";
  for (const int descriptor : open_sockets()) {
    if (before_.contains(descriptor)) continue;
    if (::setsockopt(descriptor, SOL_SOCKET, SO_BINDTODEVICE, loopback.data(), loopback.size()) !=
        0)
      throw std::system_error(errno, std::generic_category(),
                              "the bus cannot be kept to the loopback interface");
  }
}

}  // namespace drydock::bus
