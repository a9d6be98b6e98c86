#pragma once

#include <memory>

#include "drivers/link/link.hpp"

namespace drydock::link {

/// The only member, in this process, of an emulated NMEA 2000 bus with a gateway of Yacht Devices,
/// whose computers are at the other end of `line`: every frame goes to them as a RAW line, and what
/// they order is on the bus and told back as sent.
std::unique_ptr<FrameLink> join_gateway(const asio::any_io_executor& executor,
                                        std::unique_ptr<ByteLink> line);

}  // namespace drydock::link
