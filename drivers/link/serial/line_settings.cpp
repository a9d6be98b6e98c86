#include "drivers/link/serial/line_settings.hpp"

#include <asm/termbits.h>
#include <linux/serial.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <bit>
#include <cerrno>
#include <cmath>

namespace drydock::link {
namespace {

using wire::Parity;

constexpr double tolerated_baud_error = 0.025;  // a UART samples 10 bits: half a bit is 5 %
constexpr cc_t xon = 0x11, xoff = 0x13;
constexpr tcflag_t parity_flags = PARENB | PARODD | CMSPAR;
constexpr tcflag_t frame_flags = CSIZE | CSTOPB | parity_flags | CRTSCTS;

boost::system::error_code last_error() { return {errno, boost::system::system_category()}; }

void set_raw(termios2& t) {
  t.c_iflag = 0;
  t.c_oflag = 0;
  t.c_lflag = 0;
  t.c_cc[VMIN] = 1;
  t.c_cc[VTIME] = 0;
}

tcflag_t flags_of(Parity parity) {
  switch (parity) {
    case Parity::none: return 0;
    case Parity::even: return PARENB;
    case Parity::odd: return PARENB | PARODD;
    case Parity::mark: return PARENB | CMSPAR | PARODD;
    case Parity::space: return PARENB | CMSPAR;
  }
  return 0;
}

tcflag_t size_of(unsigned data_bits) {
  constexpr tcflag_t sizes[] = {CS5, CS6, CS7, CS8};
  return sizes[data_bits - 5];
}

void set_speed(termios2& t, unsigned baud) {
  t.c_cflag &= ~(CBAUD | (CBAUD << IBSHIFT));
  t.c_cflag |= BOTHER | (BOTHER << IBSHIFT);
  t.c_ispeed = t.c_ospeed = baud;
}

termios2 with(const LineSettings& settings, termios2 t) {
  set_raw(t);
  set_speed(t, settings.baud);
  t.c_cflag &= ~frame_flags;
  t.c_cflag |= CREAD | CLOCAL;
  t.c_cflag |= size_of(settings.frame.data_bits) | flags_of(settings.frame.parity);
  if (settings.frame.stop_bits == 2) t.c_cflag |= CSTOPB;
  if (settings.frame.parity != Parity::none)
    t.c_iflag |= INPCK | IGNPAR;  // drops a byte with wrong parity
  if (settings.flow == FlowControl::rtscts) t.c_cflag |= CRTSCTS;
  if (settings.flow == FlowControl::xonxoff) t.c_iflag |= IXON | IXOFF;
  t.c_cc[VSTART] = xon;
  t.c_cc[VSTOP] = xoff;
  return t;
}

/// It carries whole bytes from program to program, so it has no settings to keep.
bool is_pty(int fd) {
  constexpr unsigned first_major = 136, last_major = 143;  // UNIX98 slaves, devices.txt of Linux
  struct stat info {};
  return ::fstat(fd, &info) == 0 && major(info.st_rdev) >= first_major &&
         major(info.st_rdev) <= last_major;
}

std::string text_of(Parity parity) {
  constexpr const char* names[] = {"none", "even", "odd", "mark", "space"};
  return std::string("parity=") + names[static_cast<std::size_t>(parity)];
}

std::string text_of(FlowControl flow) {
  constexpr const char* names[] = {"none", "rtscts", "xonxoff"};
  return std::string("flow=") + names[static_cast<std::size_t>(flow)];
}

/// The first setting of `wanted` that the driver did not keep. Empty: it kept all.
std::string not_kept(const LineSettings& settings, const termios2& wanted, const termios2& kept) {
  const auto differs = [&](tcflag_t flags) {
    return ((wanted.c_cflag ^ kept.c_cflag) & flags) != 0;
  };
  if (differs(CSIZE)) return "bits=" + std::to_string(settings.frame.data_bits);
  if (differs(parity_flags)) return text_of(settings.frame.parity);
  if (differs(CSTOPB)) return "stop=" + std::to_string(settings.frame.stop_bits);
  const bool soft = ((wanted.c_iflag ^ kept.c_iflag) & (IXON | IXOFF)) != 0;
  return differs(CRTSCTS) || soft ? text_of(settings.flow) : std::string();
}

std::optional<LineRefusal> set_termios(int fd, const LineSettings& settings, const Ioctl& ioctl) {
  termios2 before{};
  if (ioctl(fd, TCGETS2, &before) != 0) return LineRefusal{last_error(), {}};
  termios2 wanted = with(settings, before);
  if (ioctl(fd, TCSETS2, &wanted) != 0) return LineRefusal{last_error(), {}};
  termios2 kept{};
  if (ioctl(fd, TCGETS2, &kept) != 0) return LineRefusal{last_error(), {}};
  const double rate = kept.c_ospeed, asked = settings.baud;
  if (std::abs(rate - asked) > tolerated_baud_error * asked)
    return LineRefusal{{ERANGE, boost::system::system_category()}, {}};
  std::string lost = is_pty(fd) ? std::string() : not_kept(settings, wanted, kept);
  return lost.empty() ? std::nullopt : std::optional(LineRefusal{{}, std::move(lost)});
}

/// Sets one control line of the modem, and reads it back.
std::optional<LineRefusal> set_level(int fd, int line, const char* key, std::optional<bool> level,
                                     const Ioctl& ioctl) {
  if (!level || is_pty(fd)) return std::nullopt;
  int levels = 0;
  const bool kept = ioctl(fd, *level ? TIOCMBIS : TIOCMBIC, &line) == 0 &&
                    ioctl(fd, TIOCMGET, &levels) == 0 && ((levels & line) != 0) == *level;
  if (kept) return std::nullopt;
  return LineRefusal{{}, std::string(key) + (*level ? "=1" : "=0")};
}

std::optional<LineRefusal> set_rs485(int fd, std::optional<bool> rts, const Ioctl& ioctl) {
  if (!rts || is_pty(fd)) return std::nullopt;
  constexpr auto flags = SER_RS485_ENABLED | SER_RS485_RTS_ON_SEND | SER_RS485_RTS_AFTER_SEND;
  serial_rs485 wanted{};
  wanted.flags = SER_RS485_ENABLED | (*rts ? SER_RS485_RTS_ON_SEND : SER_RS485_RTS_AFTER_SEND);
  serial_rs485 asked = wanted, kept{};  // the driver may write back what it made of it
  if (ioctl(fd, TIOCSRS485, &asked) == 0 && ioctl(fd, TIOCGRS485, &kept) == 0 &&
      ((wanted.flags ^ kept.flags) & flags) == 0)
    return std::nullopt;
  return LineRefusal{{}, *rts ? "rs485=high" : "rs485=low"};
}

std::optional<bool> level_of(const Uri& uri, std::string_view key, std::string_view high) {
  const auto text = uri.text_of(key);
  return text.empty() ? std::nullopt : std::optional(text == high);
}

/// Bytes from before the start have no time. A port that was plugged in since also echoed them to
/// the sensor until it was set (tty_std_termios of Linux has ECHO): what is not sent yet stays
/// here.
void forget_what_came_before(int fd, const Ioctl& ioctl) {
  const std::uintptr_t which = is_pty(fd) ? TCIFLUSH : TCIOFLUSH;
  ioctl(fd, TCFLSH, std::bit_cast<void*>(which));
}

}  // namespace

int kernel_ioctl(int fd, unsigned long request, void* argument) {
  return ::ioctl(fd, request, argument);
}

LineSettings line_settings(const Uri& uri) {
  LineSettings settings;
  settings.baud = uri.baud().value_or(settings.baud);
  settings.frame = uri.byte_frame();
  if (uri.text_of("flow") == "rtscts") settings.flow = FlowControl::rtscts;
  if (uri.text_of("flow") == "xonxoff") settings.flow = FlowControl::xonxoff;
  settings.dtr = level_of(uri, "dtr", "1");
  settings.rts = level_of(uri, "rts", "1");
  settings.rs485_rts = level_of(uri, "rs485", "high");
  return settings;
}

std::optional<LineRefusal> configure_line(int fd, const LineSettings& settings,
                                          const Ioctl& ioctl) {
  if (auto refused = set_termios(fd, settings, ioctl)) return refused;
  if (auto refused = set_rs485(fd, settings.rs485_rts, ioctl)) return refused;
  if (auto refused = set_level(fd, TIOCM_DTR, "dtr", settings.dtr, ioctl)) return refused;
  if (auto refused = set_level(fd, TIOCM_RTS, "rts", settings.rts, ioctl)) return refused;
  forget_what_came_before(fd, ioctl);
  return std::nullopt;
}

boost::system::error_code make_raw(int fd, std::optional<unsigned> baud) {
  termios2 t{};
  if (::ioctl(fd, TCGETS2, &t) != 0) return last_error();
  set_raw(t);
  if (baud) set_speed(t, *baud);
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
