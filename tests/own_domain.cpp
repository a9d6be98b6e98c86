// Tests run side by side. Two in one DDS domain would find each other's readers, and a domain that
// is counted from the process number is the same for every ninetieth process.
#include "tests/own_domain.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace drydock::test {
namespace {

/// Binds an abstract socket named after the domain. The kernel frees the name with the process.
bool hold(std::uint32_t domain) {
  const int socket = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const auto name = "drydock-test-domain-" + std::to_string(domain);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::ranges::copy(name, address.sun_path + 1);  // a name that begins with 0 is abstract: unix(7)
  const auto size = offsetof(sockaddr_un, sun_path) + 1 + name.size();
  const bool held = ::bind(socket, reinterpret_cast<const sockaddr*>(&address),
                           static_cast<socklen_t>(size)) == 0;
  if (!held) ::close(socket);
  return held;
}

std::uint32_t first_free() {
  constexpr std::uint32_t first = 10, count = 90;
  // Another process may still leave the domain of its predecessor, so the search begins anywhere.
  const auto begin = static_cast<std::uint32_t>(::getpid());
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t domain = first + (begin + i) % count;
    if (hold(domain)) return domain;
  }
  throw std::runtime_error("every DDS domain of the tests is held by a test");
}

}  // namespace

std::uint32_t own_domain() {
  static const std::uint32_t domain = first_free();
  return domain;
}

}  // namespace drydock::test
