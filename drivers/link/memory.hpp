#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// A line inside this process, found by name. The device makes it and one driver joins it; they may
/// run on different threads. Each direction holds 64 KiB; a writer waits while it is full.
OpenedBytes open_memory(const asio::any_io_executor& executor, const Uri& uri, Side side);

}  // namespace drydock::link
