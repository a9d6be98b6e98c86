#pragma once

#include "drivers/capture/capture_file.hpp"
#include "drivers/link/opening.hpp"

namespace drydock::link {

/// The capture that a file: link names, with its keys `format` and `interface`.
capture::CaptureFile capture_of(const Uri& file);

/// A capture of a CAN bus in any format of drivers/capture (`format`, else recognised by content),
/// all of its interfaces or one (`interface`). Frames come at the capture's own times, divided by
/// `speed`, or with `speed=max` as fast as they can be read. Its end is asio::error::eof. What is
/// written to it is not heard by anybody.
OpenedFrames open_frame_file(const asio::any_io_executor& executor, const Uri& uri, Side side);

}  // namespace drydock::link
