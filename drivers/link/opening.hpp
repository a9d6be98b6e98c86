#pragma once

#include <boost/asio/as_tuple.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <memory>
#include <string>

#include "drivers/link/link.hpp"

/// Common parts of the links. Internal to drivers/link.
namespace drydock::link {

using OpenedBytes = boost::system::result<std::unique_ptr<ByteLink>, OpenError>;
using OpenedFrames = boost::system::result<std::unique_ptr<FrameLink>, OpenError>;

using ErrorCode = boost::system::error_code;

/// Completion token of every operation: the outcome is a value, never an exception.
inline constexpr auto as_outcome = asio::as_tuple(asio::use_awaitable);

inline ErrorCode system_error(int number) { return {number, boost::system::system_category()}; }

/// `message`, followed by the system's own words for `number` (an errno).
inline OpenError open_error(int number, const std::string& message) {
  return {system_error(number), message + ": " + system_error(number).message()};
}

}  // namespace drydock::link
