#pragma once

#include "drivers/link/opening.hpp"
#include "drivers/measurement/message_time.hpp"

namespace drydock::link {

/// Why a file: link cannot be opened: a device asks for it, its keys do not fit, or it is no
/// regular file.
std::optional<OpenError> refuse_file(const Uri& uri, Side side, Carries what);

/// A recording of raw bytes, without the comments at its head (`format=raw` keeps them). It is
/// read at the pace of its line (`baud`, times `speed`), or each message at its time in `messages`
/// (times `speed`); the reads of a line in a file of packets at their own times. With `speed=max`,
/// or without a baud and such times, it is read as fast as possible. Its end is asio::error::eof.
/// Written bytes are discarded.
OpenedBytes open_file(const asio::any_io_executor& executor, const Uri& uri, Side side,
                      measurement::MessageTimes messages = {});

}  // namespace drydock::link
