#pragma once

#include <string_view>

#include "drivers/link/uri.hpp"

namespace drydock::host {

/// What to try where a link of this scheme is lost or cannot be opened. Empty: what stands with the
/// cause, which is for a serial port.
constexpr std::string_view port_advice(link::Scheme scheme) {
  switch (scheme) {
    case link::Scheme::pty:
    case link::Scheme::can_auto:  // an emulated bus: the emulator makes it
      return "start what is at its other end, such as `drydock emulate`";
    case link::Scheme::tcp:
      return "look at host and port, the network, and whether the device takes a client";
    case link::Scheme::udp:
      return "look at host and port, and whether another program has the port";
    case link::Scheme::file: return "look whether the file is there and may be read";
    case link::Scheme::socketcan: return "look whether the interface is there and up: `ip link`";
    case link::Scheme::slcan:
      return "look at the adapter and its plug, whether it knows the bit rate, and whether another "
             "program has it open";
    case link::Scheme::gateway:
      return "look at the gateway's host and port, its bit rate, and whether it takes a client";
    case link::Scheme::serial:
    case link::Scheme::memory:
    case link::Scheme::memory_can: break;
  }
  return {};
}

}  // namespace drydock::host
