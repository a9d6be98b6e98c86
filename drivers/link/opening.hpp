#pragma once

#include <memory>
#include <string>

#include "drivers/io/as_outcome.hpp"
#include "drivers/link/link.hpp"

/// Common parts of the links. Internal to drivers/link.
namespace drydock::link {

using OpenedBytes = boost::system::result<std::unique_ptr<ByteLink>, OpenError>;
using OpenedFrames = boost::system::result<std::unique_ptr<FrameLink>, OpenError>;

using ErrorCode = boost::system::error_code;

using io::as_outcome;

inline ErrorCode system_error(int number) { return {number, boost::system::system_category()}; }

/// `message`, followed by the system's own words for `number` (an errno).
inline OpenError open_error(int number, const std::string& message) {
  return {system_error(number), message + ": " + system_error(number).message()};
}

}  // namespace drydock::link
