#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>

#include "drivers/link/opening.hpp"

namespace drydock::link {

struct HostAndPort {
  std::string host, port;
};

/// Splits "192.168.194.95:1037", "localhost:4001", "[::1]:4001".
HostAndPort host_and_port(const std::string& target);

/// First address of the URI's host. The call waits for the look-up of a name; a numeric address
/// needs none.
boost::system::result<asio::ip::tcp::endpoint, OpenError> tcp_endpoint(const Uri& uri);
boost::system::result<asio::ip::udp::endpoint, OpenError> udp_endpoint(const Uri& uri);

}  // namespace drydock::link
