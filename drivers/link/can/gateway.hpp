#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// `gateway:` URIs: NMEA 2000 behind a gateway that sends its frames as lines of text, on any byte
/// link. `format` names the lines, those of a capture of that format: RAW of Yacht Devices (which
/// also takes frames), N2K ASCII of Actisense, iKonvert of Digital Yacht (both are only heard). A
/// frame gets its stamp when its bytes are read: the gateway's own stamps are times of day of its
/// own clock. The device side is an emulated gateway of Yacht Devices; its bus has no other
/// members.
OpenedFrames open_gateway(const asio::any_io_executor& executor, const Uri& uri, Side side);

}  // namespace drydock::link
