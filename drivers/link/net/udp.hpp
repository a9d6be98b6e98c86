#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// Datagrams as a byte stream, to and from one host, a broadcast address or a multicast group. One
/// end binds the URI's address and answers the last sender; the other end sends to that address, at
/// first an empty datagram. A driver takes only what one host sends: the URI's `from`, or else the
/// one that it hears first; without `from` it takes all that a group or a broadcast address gets.
/// By default the device binds; with `listen=1` the driver does (sensors that broadcast). Where the
/// end that sends has a host's name, it finds the host at its first read or write.
OpenedBytes open_udp(const asio::any_io_executor& executor, const Uri& uri, Side side);

}  // namespace drydock::link
