#pragma once

#include <boost/system/error_code.hpp>
#include <boost/system/result.hpp>
#include <functional>
#include <optional>
#include <string>

#include "drivers/link/uri.hpp"

/// Settings of a terminal device of the kernel for raw bytes.
namespace drydock::link {

enum class FlowControl : std::uint8_t { none, rtscts, xonxoff };

struct LineSettings {
  unsigned baud = 9600;
  wire::ByteFrame frame;
  FlowControl flow = FlowControl::none;
  std::optional<bool> dtr, rts;  ///< levels after the opening; empty: as the kernel sets them
  std::optional<bool>
      rs485_rts;  ///< level of RTS while an RS-485 transmitter sends; empty: no RS-485
};

/// The settings that a serial or pty URI names.
LineSettings line_settings(const Uri& uri);

/// The kernel's ioctl, or a stand-in for it.
using Ioctl = std::function<int(int fd, unsigned long request, void* argument)>;
int kernel_ioctl(int fd, unsigned long request, void* argument);

/// Why a port cannot be used: an errno, or the setting that it did not take.
struct LineRefusal {
  boost::system::error_code code;
  std::string setting;  ///< as a key of the URI, "parity=even"; empty: see `code`
};

/// Raw bytes at any baud (termios2, BOTHER); a read waits for one byte. Everything is read back
/// from the driver. ERANGE: the nearest rate of the port is more than 2.5 % away, and such a line
/// would give nothing but framing errors. A pty has no line: of it, only the rate is read back.
std::optional<LineRefusal> configure_line(int fd, const LineSettings& settings,
                                          const Ioctl& ioctl = kernel_ioctl);

/// Raw bits, no echo, and a rate where one is given; all else is unchanged. For the end of a pty
/// that the process keeps open: a program that sets no rate finds this one.
boost::system::error_code make_raw(int fd, std::optional<unsigned> baud = {});

/// The rate of the line according to the kernel, bit/s.
boost::system::result<unsigned> line_baud(int fd);

/// Asks the driver to deliver bytes at once (otherwise an FTDI chip keeps them for 16 ms). Drivers
/// without this flag are already fast.
void request_low_latency(int fd);

}  // namespace drydock::link
