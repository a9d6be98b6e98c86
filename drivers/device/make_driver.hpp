#pragma once

#include <boost/container/static_vector.hpp>
#include <boost/system/result.hpp>
#include <memory>
#include <string>
#include <string_view>

#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/wire/protocols.hpp"

namespace drydock::device {

/// One line: the error and the permitted values.
struct DriverError {
  std::string message;
};

/// Called by result::value() if there is no driver; throws std::invalid_argument.
[[noreturn]] void throw_exception_from_error(const DriverError& error,
                                             const boost::source_location& where);

using wire::Travels;

struct ProtocolEntry {
  std::string_view name;
  Travels travels;
};

/// The protocols that the drivers understand for a kind of sensor.
boost::container::static_vector<ProtocolEntry, 16> protocols_of(Kind kind);

boost::system::result<std::unique_ptr<ByteDriver>, DriverError> make_byte_driver(
    const DriverOptions& options);
boost::system::result<std::unique_ptr<FrameDriver>, DriverError> make_frame_driver(
    const DriverOptions& options);

}  // namespace drydock::device
