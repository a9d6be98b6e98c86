#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// The device's end: makes a pty and a symbolic link to it under the name of the URI. It stays
/// while drivers come and go. One slave descriptor stays open, because the master would otherwise
/// read EIO.
OpenedBytes open_pty_device(const asio::any_io_executor& executor, const Uri& uri);

}  // namespace drydock::link
