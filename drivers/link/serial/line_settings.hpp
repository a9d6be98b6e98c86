#pragma once

#include <boost/system/error_code.hpp>
#include <boost/system/result.hpp>

#include "drivers/link/uri.hpp"

/// How a terminal device of the kernel carries raw bytes.
namespace drydock::link {

struct LineSettings {
  enum class Parity : unsigned char { none, even, odd };
  unsigned baud = 9600;
  Parity parity = Parity::none;
  unsigned stop_bits = 1;
  unsigned data_bits = 8;
};

/// The settings a serial or pty URI names.
LineSettings line_settings(const Uri& uri);

/// Raw bytes at any baud (termios2, BOTHER), no flow control, a read waits for one byte.
/// Fails with ERANGE when the port can only do a rate more than 2.5 % away: such a line would
/// carry nothing but framing errors.
boost::system::error_code configure_line(int fd, const LineSettings& settings);

/// Raw bits and no echo, the rest as it is: for the kept end of a pty.
boost::system::error_code make_raw(int fd);

/// The rate that the kernel says the line has, bit/s.
boost::system::result<unsigned> line_baud(int fd);

/// Asks the driver to hand over bytes at once (an FTDI chip otherwise keeps them for 16 ms).
/// Drivers that know no such flag are fast already.
void request_low_latency(int fd);

}  // namespace drydock::link
