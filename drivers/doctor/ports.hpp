#pragma once

#include <optional>
#include <string>
#include <vector>

namespace drydock::doctor {

/// A serial port of this machine, from /sys and /dev.
struct SerialPort {
  std::string path;    ///< /dev/ttyUSB0
  std::string by_id;   ///< the same name in every socket; empty: none
  std::string driver;  ///< ftdi_sio, cp210x, cdc_acm, ...
  std::string usb_id;  ///< 0403:6001; empty: not on USB
  std::string product;
};

/// Whether this user may open a port, and whose it is.
struct PortAccess {
  bool allowed = false;
  std::string mode;   ///< "660"
  std::string group;  ///< its name, or its number
};
PortAccess access_of(const std::string& root, const std::string& path);

/// A CAN network interface.
struct CanPort {
  std::string name;
  bool up = false, is_virtual = false;
  std::string state;  ///< state of the controller
  std::optional<unsigned> bitrate;
};

/// Searches under `root`, which is "/" except in tests. It lists ports of the PC's chipset only if
/// they have hardware.
std::vector<SerialPort> serial_ports(const std::string& root);

/// The names come from /sys. If root is "/", netlink gives the state of each.
std::vector<CanPort> can_ports(const std::string& root);

}  // namespace drydock::doctor
