#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// Datagrams as a byte stream, to and from one host, a broadcast address or a multicast group. One
/// end binds the URI's address and answers the last sender; the other end sends to that address. By
/// default the device binds; with `listen=1` the driver does (sensors that broadcast). The end that
/// sends to the address finds its host at the first read or write, and then begins with an empty
/// datagram.
OpenedBytes open_udp(const asio::any_io_executor& executor, const Uri& uri, Side side);

}  // namespace drydock::link
