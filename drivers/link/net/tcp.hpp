#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// Connects to a device server. The first read or write finds the host and connects to it; it tries
/// all addresses of the name in turn, each for at most 2 s, and reports the last outcome.
OpenedBytes open_tcp_client(const asio::any_io_executor& executor, const Uri& uri);

/// A device that listens. It serves one client at a time; others wait in the kernel's queue.
OpenedBytes open_tcp_server(const asio::any_io_executor& executor, const Uri& uri);

}  // namespace drydock::link
