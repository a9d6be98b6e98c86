#include "drivers/link/net/udp_socket.hpp"

#include <netinet/in.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>

namespace drydock::link {
namespace {

using asio::ip::udp;

template <class Value>
ErrorCode set(udp::socket& socket, int level, int name, const Value& value) {
  const bool done = ::setsockopt(socket.native_handle(), level, name, &value, sizeof value) == 0;
  return done ? ErrorCode{} : system_error(errno);
}

/// A group of IPv6 is one of an interface.
UdpEndpoint on_interface(UdpEndpoint endpoint, unsigned interface) {
  if (!endpoint.address().is_v6() || !endpoint.address().is_multicast()) return endpoint;
  auto group = endpoint.address().to_v6();
  if (interface != 0) group.scope_id(interface);
  return {group, endpoint.port()};
}

/// The kernel knows its networks: it refuses a connection to a broadcast address.
bool is_broadcast(const asio::any_io_executor& executor, const UdpEndpoint& endpoint) {
  ErrorCode error;
  udp::socket probe(executor);
  probe.open(endpoint.protocol(), error);
  if (!error) probe.connect(endpoint, error);
  return error == asio::error::access_denied;
}

ErrorCode join(udp::socket& socket, const UdpEndpoint& group, unsigned interface) {
  group_req request{};
  request.gr_interface = interface;
  std::memcpy(&request.gr_group, group.data(), group.size());
  const int level = group.address().is_v4() ? IPPROTO_IP : IPPROTO_IPV6;
  if (const auto error = set(socket, level, MCAST_JOIN_GROUP, request)) return error;
  // Otherwise it would also hear the groups that other programs joined on other interfaces.
  constexpr int no = 0;
  return group.address().is_v4() ? set(socket, IPPROTO_IP, IP_MULTICAST_ALL, no)
                                 : set(socket, IPPROTO_IPV6, IPV6_MULTICAST_ALL, no);
}

ErrorCode send_through(udp::socket& socket, const UdpEndpoint& group, unsigned interface) {
  if (interface == 0) return {};
  if (group.address().is_v6()) return set(socket, IPPROTO_IPV6, IPV6_MULTICAST_IF, interface);
  ip_mreqn request{};
  request.imr_ifindex = static_cast<int>(interface);
  return set(socket, IPPROTO_IP, IP_MULTICAST_IF, request);
}

}  // namespace

bool has_many_listeners(const asio::any_io_executor& executor, const UdpEndpoint& endpoint) {
  return endpoint.address().is_multicast() || is_broadcast(executor, endpoint);
}

ErrorCode listen_on(udp::socket& socket, UdpEndpoint endpoint, unsigned interface) {
  endpoint = on_interface(endpoint, interface);
  const bool is_group = endpoint.address().is_multicast();
  const bool has_many = has_many_listeners(socket.get_executor(), endpoint);
  ErrorCode error;
  socket.open(endpoint.protocol(), error);
  if (!error && has_many) socket.set_option(udp::socket::reuse_address(true), error);
  if (!error) socket.bind(endpoint, error);
  if (!error && is_group) error = join(socket, endpoint, interface);
  return error;
}

ErrorCode aim_at(udp::socket& socket, UdpEndpoint endpoint, unsigned interface) {
  endpoint = on_interface(endpoint, interface);
  ErrorCode error;
  if (socket.is_open()) socket.close(error);
  socket.open(endpoint.protocol(), error);
  if (error) return error;
  if (endpoint.address().is_multicast()) {
    error = send_through(socket, endpoint, interface);
  } else {
    socket.connect(endpoint, error);
    if (!error) {
      socket.send(asio::const_buffer{}, 0, error);
      return error;
    }
    if (error == asio::error::access_denied)  // a broadcast address
      socket.set_option(udp::socket::broadcast(true), error);
  }
  if (!error) socket.send_to(asio::const_buffer{}, endpoint, 0, error);
  return error;
}

}  // namespace drydock::link
