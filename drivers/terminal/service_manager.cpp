#include "drivers/terminal/service_manager.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>

namespace drydock::terminal {
namespace {

/// Connects to a path, or with a leading @ to an abstract name. -1: it cannot.
int connected(const char* name) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::size_t size = std::strlen(name);
  if (size == 0 || size >= sizeof address.sun_path) return -1;
  std::memcpy(address.sun_path, name, size);
  if (name[0] == '@') address.sun_path[0] = '\0';
  const int socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + size);
  if (::connect(socket, reinterpret_cast<const sockaddr*>(&address), length) == 0) return socket;
  ::close(socket);
  return -1;
}

}  // namespace

ServiceManager::ServiceManager() {
  if (const char* name = std::getenv("NOTIFY_SOCKET")) socket_ = connected(name);
}

ServiceManager::~ServiceManager() {
  if (socket_ >= 0) ::close(socket_);
}

void ServiceManager::tell(std::string_view text) const {
  if (socket_ >= 0) ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
}

}  // namespace drydock::terminal
