#pragma once

#include "drivers/capture/capture_file.hpp"
#include "drivers/link/opening.hpp"

namespace drydock::link {

/// The capture that a file: link names, with the link's keys `format` and `interface`.
capture::CaptureFile capture_of(const Uri& file);

/// A capture of a CAN bus in any format of drivers/capture (key `format`, otherwise recognised by
/// content). It plays all interfaces or one (key `interface`). Frames come at the capture's own
/// times, divided by `speed`. With `speed=max` they come as fast as possible. Its end is
/// asio::error::eof. Written frames are discarded.
OpenedFrames open_frame_file(const asio::any_io_executor& executor, const Uri& uri, Side side);

}  // namespace drydock::link
