#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// A recording of raw bytes, read at the pace of its line (`baud`, times `speed`) or, with
/// `speed=max` or no baud, as fast as it can be read. Its end is asio::error::eof. What is written
/// to it is not heard by anybody.
OpenedBytes open_file(const asio::any_io_executor& executor, const Uri& uri, Side side);

}  // namespace drydock::link
