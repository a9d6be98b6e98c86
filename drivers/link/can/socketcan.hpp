#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// A CAN interface of the kernel (CAN_RAW): receive stamps of the kernel, all error frames, the
/// kernel's count of frames lost in the queue. `fd=1` lets CAN FD frames through; `echo=1` also
/// returns our own frames once they were on the bus, marked `own`.
OpenedFrames open_socketcan(const asio::any_io_executor& executor, const Uri& uri);

}  // namespace drydock::link
