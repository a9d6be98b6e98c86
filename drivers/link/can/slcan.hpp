#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// The computer's end of an slcan adapter on any byte link. The first read or write opens the
/// channel at `bit_rate`: an empty line (it ends an incomplete one), C, S, O. A frame gets its
/// stamp when its bytes are read: the adapter's own stamps have only milliseconds and an epoch of
/// their own.
std::unique_ptr<FrameLink> make_slcan(const asio::any_io_executor& executor,
                                      std::unique_ptr<ByteLink> line, unsigned bit_rate);

/// `slcan:` URIs. The device side is an emulated adapter; its bus has no other members.
OpenedFrames open_slcan(const asio::any_io_executor& executor, const Uri& uri, Side side);

}  // namespace drydock::link
