#pragma once

#include <boost/asio/as_tuple.hpp>
#include <boost/asio/use_awaitable.hpp>

namespace drydock::io {

/// Completion of every operation: the outcome is a value, never an exception.
inline constexpr auto as_outcome = boost::asio::as_tuple(boost::asio::use_awaitable);

}  // namespace drydock::io
