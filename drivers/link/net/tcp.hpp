#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// Connects to a device server. The first read or write finds the host and connects to it; it tries
/// all addresses of the name in turn, each for at most 2 s, and reports the last outcome.
OpenedBytes open_tcp_client(const asio::any_io_executor& executor, const Uri& uri);

/// A device that listens. It serves as many clients as the URI's `clients` says (1 if it is not
/// given); one client more makes the oldest leave. All hear the same, and all are heard. A client
/// that takes nothing for 1 s while 64 KiB and the kernel's buffers are full is thrown out.
OpenedBytes open_tcp_server(const asio::any_io_executor& executor, const Uri& uri);

}  // namespace drydock::link
