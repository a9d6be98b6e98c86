#include "drivers/link/net/endpoint.hpp"

#include <charconv>

namespace drydock::link {

HostAndPort host_and_port(const std::string& target) {
  const std::size_t colon = target.rfind(':');
  std::string host = target.substr(0, colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']')
    host = host.substr(1, host.size() - 2);
  std::uint16_t port = 0;
  std::from_chars(target.data() + colon + 1, target.data() + target.size(), port);
  return {host, port};
}

}  // namespace drydock::link
