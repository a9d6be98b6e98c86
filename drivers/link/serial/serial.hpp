#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// A serial port of the kernel for exclusive use (TIOCEXCL, and a lock that also stops root).
OpenedBytes open_serial(const asio::any_io_executor& executor, const Uri& uri);

/// The driver's end of a pty: a serial port that other programs may open as well.
OpenedBytes open_pty_driver(const asio::any_io_executor& executor, const Uri& uri);

}  // namespace drydock::link
