#pragma once

#include <boost/system/error_code.hpp>
#include <boost/system/result.hpp>

#include "drivers/link/uri.hpp"

/// Settings of a terminal device of the kernel for raw bytes.
namespace drydock::link {

struct LineSettings {
  enum class Parity : unsigned char { none, even, odd };
  unsigned baud = 9600;
  Parity parity = Parity::none;
  unsigned stop_bits = 1;
  unsigned data_bits = 8;
};

/// The settings that a serial or pty URI names.
LineSettings line_settings(const Uri& uri);

/// Raw bytes at any baud (termios2, BOTHER), no flow control; a read waits for one byte. Fails with
/// ERANGE if the nearest rate of the port is more than 2.5 % away: such a line would give nothing
/// but framing errors.
boost::system::error_code configure_line(int fd, const LineSettings& settings);

/// Raw bits and no echo; all else is unchanged. For the end of a pty that the process keeps open.
boost::system::error_code make_raw(int fd);

/// The rate of the line according to the kernel, bit/s.
boost::system::result<unsigned> line_baud(int fd);

/// Asks the driver to deliver bytes at once (otherwise an FTDI chip keeps them for 16 ms). Drivers
/// without this flag are already fast.
void request_low_latency(int fd);

}  // namespace drydock::link
