#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// Datagrams as a byte stream. One end binds the URI's address and answers to the last sender, the
/// other sends to that address: by default the device binds, with `listen=1` the driver does
/// (sensors that broadcast). The sending end says hello with an empty datagram.
OpenedBytes open_udp(const asio::any_io_executor& executor, const Uri& uri, Side side);

}  // namespace drydock::link
