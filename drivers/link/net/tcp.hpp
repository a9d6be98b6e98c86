#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// Connects to a device server. It returns before the connection is established; the first read or
/// write waits for it and reports the outcome.
OpenedBytes open_tcp_client(const asio::any_io_executor& executor, const Uri& uri);

/// A device that listens. It serves one client at a time; others wait in the kernel's queue.
OpenedBytes open_tcp_server(const asio::any_io_executor& executor, const Uri& uri);

}  // namespace drydock::link
