#include "drivers/link/serial/line_settings.hpp"

#include <asm/termbits.h>
#include <linux/serial.h>
#include <sys/ioctl.h>

#include <cerrno>
#include <cmath>

namespace drydock::link {
namespace {

constexpr double tolerated_baud_error = 0.025;  // a UART samples 10 bits: half a bit is 5 %

boost::system::error_code last_error() { return {errno, boost::system::system_category()}; }

void set_raw(termios2& t) {
  t.c_iflag = 0;
  t.c_oflag = 0;
  t.c_lflag = 0;
  t.c_cc[VMIN] = 1;
  t.c_cc[VTIME] = 0;
}

void set_parity(termios2& t, LineSettings::Parity parity) {
  t.c_cflag &= ~(PARENB | PARODD | CMSPAR);
  if (parity == LineSettings::Parity::none) return;
  t.c_cflag |= PARENB;
  if (parity == LineSettings::Parity::odd) t.c_cflag |= PARODD;
  t.c_iflag |= INPCK | IGNPAR;  // drops a byte with wrong parity
}

}  // namespace

LineSettings line_settings(const Uri& uri) {
  LineSettings settings;
  settings.baud = uri.baud().value_or(settings.baud);
  if (const auto parity = uri.query.find("parity"); parity != uri.query.end()) {
    if (parity->second == "even") settings.parity = LineSettings::Parity::even;
    if (parity->second == "odd") settings.parity = LineSettings::Parity::odd;
  }
  settings.data_bits = uri.text_of("bits") == "7" ? 7 : 8;
  const auto stop = uri.query.find("stop");
  settings.stop_bits = stop != uri.query.end() && stop->second == "2" ? 2 : 1;
  return settings;
}

boost::system::error_code configure_line(int fd, const LineSettings& settings) {
  termios2 t{};
  if (::ioctl(fd, TCGETS2, &t) != 0) return last_error();
  set_raw(t);
  t.c_cflag &= ~(CBAUD | (CBAUD << IBSHIFT) | CSIZE | CSTOPB | CRTSCTS);
  t.c_cflag |= BOTHER | (BOTHER << IBSHIFT) | CREAD | CLOCAL;
  t.c_cflag |= settings.data_bits == 7 ? CS7 : CS8;
  if (settings.stop_bits == 2) t.c_cflag |= CSTOPB;
  set_parity(t, settings.parity);
  t.c_ispeed = t.c_ospeed = settings.baud;
  if (::ioctl(fd, TCSETS2, &t) != 0) return last_error();
  ::ioctl(fd, TCFLSH, TCIFLUSH);  // bytes from before the start have no time

  const auto actual = line_baud(fd);
  if (!actual) return actual.error();
  const double wanted = settings.baud;
  if (std::abs(*actual - wanted) > tolerated_baud_error * wanted)
    return {ERANGE, boost::system::system_category()};
  return {};
}

boost::system::error_code make_raw(int fd) {
  termios2 t{};
  if (::ioctl(fd, TCGETS2, &t) != 0) return last_error();
  set_raw(t);
  return ::ioctl(fd, TCSETS2, &t) == 0 ? boost::system::error_code{} : last_error();
}

boost::system::result<unsigned> line_baud(int fd) {
  termios2 t{};
  if (::ioctl(fd, TCGETS2, &t) != 0) return last_error();
  return t.c_ospeed;
}

void request_low_latency(int fd) {
  serial_struct serial{};
  if (::ioctl(fd, TIOCGSERIAL, &serial) != 0) return;
  serial.flags |= ASYNC_LOW_LATENCY;
  ::ioctl(fd, TIOCSSERIAL, &serial);
}

}  // namespace drydock::link
