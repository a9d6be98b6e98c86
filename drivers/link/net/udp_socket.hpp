#pragma once

#include <boost/asio/ip/udp.hpp>
#include <string>

#include "drivers/link/opening.hpp"

/// Sockets for datagrams to one host, to all hosts of a network (broadcast) and to those that have
/// joined a group (multicast).
namespace drydock::link {

using UdpEndpoint = asio::ip::udp::endpoint;

/// True for a group and for the broadcast address of a network.
bool has_many_listeners(const asio::any_io_executor& executor, const UdpEndpoint& endpoint);

/// Binds the socket, which must not be open. It joins the group if the address is one. Broadcasts
/// and groups have many listeners, so other sockets may bind the same address; any other address
/// is for one alone. `interface` is the kernel's index of the one on which a group is; 0: as it
/// routes the group.
ErrorCode listen_on(asio::ip::udp::socket& socket, UdpEndpoint endpoint, unsigned interface);

/// Opens the socket and sends an empty datagram to the address. A socket that speaks to one host is
/// connected, so that the kernel reports when nobody is there.
ErrorCode aim_at(asio::ip::udp::socket& socket, UdpEndpoint endpoint, unsigned interface);

}  // namespace drydock::link
