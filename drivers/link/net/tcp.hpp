#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// Connects to a device server. The connection is under way when this returns; the first read or
/// write waits for it and says what became of it.
OpenedBytes open_tcp_client(const asio::any_io_executor& executor, const Uri& uri);

/// A device that listens. One client at a time; others wait in the queue of the kernel.
OpenedBytes open_tcp_server(const asio::any_io_executor& executor, const Uri& uri);

}  // namespace drydock::link
