#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// Why a file: link cannot be opened: a device asks for it, its keys do not fit, or it is no
/// regular file.
std::optional<OpenError> refuse_file(const Uri& uri, Side side, Carries what);

/// A recording of raw bytes, without the '#' lines that it may begin with (kept with `format=raw`),
/// read at the pace of its line (`baud`, times `speed`) or, with
/// `speed=max` or no baud, as fast as it can be read. Its end is asio::error::eof. What is written
/// to it is not heard by anybody.
OpenedBytes open_file(const asio::any_io_executor& executor, const Uri& uri, Side side);

}  // namespace drydock::link
