// The kernel's own termios clashes with the C library's, so this file is compiled apart.
#include "drivers/link/serial/line_settings.hpp"

#include <asm/termbits.h>
#include <gtest/gtest.h>
#include <linux/serial.h>
#include <sys/ioctl.h>

#include <bit>
#include <cerrno>
#include <cstdint>

namespace drydock::link::testing {
namespace {

/// A port of a driver that keeps some settings and changes others without a word, as termios(3)
/// allows it to.
struct FakePort {
  termios2 line{};
  tcflag_t cannot = 0;        ///< flags of c_cflag that stay 0
  tcflag_t cannot_input = 0;  ///< the same of c_iflag
  bool has_modem_lines = true, has_rs485 = true;
  int modem = TIOCM_DTR | TIOCM_RTS;  // the kernel raises both when a port is opened
  serial_rs485 rs485{};
  std::uintptr_t flushed = ~std::uintptr_t{0};

  int operator()(int, unsigned long request, void* argument) {
    switch (request) {
      case TCGETS2: *static_cast<termios2*>(argument) = line; return 0;
      case TCSETS2:
        line = *static_cast<termios2*>(argument);
        line.c_cflag &= ~cannot;
        line.c_iflag &= ~cannot_input;
        return 0;
      case TIOCMGET: *static_cast<int*>(argument) = modem; return has_modem_lines ? 0 : none();
      case TIOCMBIS: modem |= *static_cast<int*>(argument); return has_modem_lines ? 0 : none();
      case TIOCMBIC: modem &= ~*static_cast<int*>(argument); return has_modem_lines ? 0 : none();
      case TIOCSRS485: rs485 = *static_cast<serial_rs485*>(argument); return has_rs485 ? 0 : none();
      case TIOCGRS485: *static_cast<serial_rs485*>(argument) = rs485; return has_rs485 ? 0 : none();
      case TCFLSH: flushed = std::bit_cast<std::uintptr_t>(argument); return 0;
      default: return 0;
    }
  }
  static int none() {
    errno = ENOTTY;
    return -1;
  }
};

/// "" if the port took all settings of these keys, else the one that it did not take.
std::string refusal(FakePort& port, const std::string& keys) {
  const auto uri = parse_uri("serial:/dev/ttyS0?baud=9600" + keys).value();
  const auto refused = configure_line(-1, line_settings(uri), std::ref(port));
  if (!refused) return "";
  return refused->setting.empty() ? refused->code.message() : refused->setting;
}

constexpr tcflag_t frame = CSIZE | CSTOPB | PARENB | PARODD | CMSPAR | CRTSCTS;

struct Case {
  const char* keys;
  tcflag_t flags;  ///< of c_cflag, termios(3)
};

TEST(LineSettings, EveryKeyReachesThePort) {
  for (const auto& [keys, flags] :
       {Case{"", CS8}, Case{"&parity=even", CS8 | PARENB},
        Case{"&parity=odd", CS8 | PARENB | PARODD},
        Case{"&parity=mark", CS8 | PARENB | CMSPAR | PARODD},
        Case{"&parity=space", CS8 | PARENB | CMSPAR}, Case{"&bits=7&parity=even", CS7 | PARENB},
        Case{"&bits=6", CS6}, Case{"&bits=5", CS5}, Case{"&stop=2", CS8 | CSTOPB},
        Case{"&flow=rtscts", CS8 | CRTSCTS}, Case{"&flow=xonxoff", CS8}}) {
    FakePort port;
    port.line.c_cflag = CS6 | PARENB | CSTOPB | CRTSCTS;  // left by the program before
    EXPECT_EQ(refusal(port, keys), "") << keys;
    EXPECT_EQ(port.line.c_cflag & frame, flags) << keys;
    EXPECT_EQ(port.line.c_ospeed, 9600U);
  }
}

/// Until it is set, a port that was plugged in since echoes (tty_std_termios of Linux).
TEST(LineSettings, NeitherWhatCameBeforeThemNorItsEchoGoesOn) {
  FakePort port;
  EXPECT_EQ(refusal(port, ""), "");
  EXPECT_EQ(port.flushed, std::uintptr_t{TCIOFLUSH});
}

TEST(LineSettings, XonAndXoffAreTheUsualCharactersAndOnlyThenTakenOutOfTheBytes) {
  FakePort port;
  EXPECT_EQ(refusal(port, "&flow=xonxoff"), "");
  EXPECT_EQ(port.line.c_iflag & (IXON | IXOFF | IXANY), tcflag_t{IXON | IXOFF});
  EXPECT_EQ(port.line.c_cc[VSTART], 0x11);
  EXPECT_EQ(port.line.c_cc[VSTOP], 0x13);
  EXPECT_EQ(refusal(port, ""), "");
  EXPECT_EQ(port.line.c_iflag & (IXON | IXOFF), tcflag_t{0});
}

TEST(LineSettings, WhatTheDriverDidNotTakeIsNamed) {
  const auto of = [](tcflag_t cannot, const char* keys) {
    FakePort port;
    port.cannot = cannot;
    return refusal(port, keys);
  };
  EXPECT_EQ(of(PARENB, "&parity=even"), "parity=even");
  EXPECT_EQ(of(CMSPAR, "&parity=mark"), "parity=mark");
  EXPECT_EQ(of(CS6, "&bits=7"), "") << "CS7 without the bit of CS6";
  EXPECT_EQ(of(CS7, "&bits=7"), "bits=7");
  EXPECT_EQ(of(CSTOPB, "&stop=2"), "stop=2");
  EXPECT_EQ(of(CRTSCTS, "&flow=rtscts"), "flow=rtscts");
  EXPECT_EQ(of(PARENB | CSTOPB | CRTSCTS, ""), "");
  FakePort port;
  port.cannot_input = IXOFF;
  EXPECT_EQ(refusal(port, "&flow=xonxoff"), "flow=xonxoff");
}

TEST(LineSettings, TheLevelsOfDtrAndRtsAreThoseOfTheirKeysOrElseTheKernels) {
  FakePort port;
  EXPECT_EQ(refusal(port, ""), "");
  EXPECT_EQ(port.modem, TIOCM_DTR | TIOCM_RTS);
  EXPECT_EQ(refusal(port, "&dtr=0"), "");
  EXPECT_EQ(port.modem, TIOCM_RTS);
  EXPECT_EQ(refusal(port, "&dtr=1&rts=0"), "");
  EXPECT_EQ(port.modem, TIOCM_DTR);
  port.has_modem_lines = false;
  EXPECT_EQ(refusal(port, "&dtr=0"), "dtr=0");
  EXPECT_EQ(refusal(port, "&rts=1"), "rts=1");
}

// Documentation/driver-api/serial/serial-rs485.rst of Linux
TEST(LineSettings, Rs485SwitchesTheTransmitterByRts) {
  FakePort port;
  EXPECT_EQ(refusal(port, ""), "");
  EXPECT_EQ(port.rs485.flags, 0U);
  EXPECT_EQ(refusal(port, "&rs485=high"), "");
  EXPECT_EQ(port.rs485.flags, __u32{SER_RS485_ENABLED | SER_RS485_RTS_ON_SEND});
  EXPECT_EQ(refusal(port, "&rs485=low"), "");
  EXPECT_EQ(port.rs485.flags, __u32{SER_RS485_ENABLED | SER_RS485_RTS_AFTER_SEND});
  port.has_rs485 = false;
  EXPECT_EQ(refusal(port, "&rs485=high"), "rs485=high");
}

}  // namespace
}  // namespace drydock::link::testing
