#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// A CAN interface of the kernel (CAN_RAW): the kernel's receive stamps, all error frames, the
/// kernel's count of frames lost in the queue. `fd=1` permits CAN FD frames. `echo=1` also returns
/// the frames that this socket sent, once they were on the bus, marked `own`.
OpenedFrames open_socketcan(const asio::any_io_executor& executor, const Uri& uri);

}  // namespace drydock::link
