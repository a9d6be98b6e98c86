#pragma once

#include "drivers/link/net/host.hpp"

namespace drydock::link {

struct HostAndPort {
  std::string host;
  std::uint16_t port = 0;
};

/// Splits "192.168.194.95:1037", "localhost:4001", "[::1]:4001".
HostAndPort host_and_port(const std::string& target);

/// Where the listening end of this URI listens: its host's first address.
template <class Protocol>
boost::system::result<typename Protocol::endpoint, OpenError> own_endpoint(const Uri& uri) {
  const auto [host, port] = host_and_port(uri.target);
  const auto addresses = own_addresses(host);
  if (!addresses)
    return OpenError{addresses.error(),
                     "cannot listen on " + uri.target + ": " + addresses.error().message()};
  return typename Protocol::endpoint(addresses->front(), port);
}

}  // namespace drydock::link
