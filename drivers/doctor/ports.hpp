#pragma once

#include <optional>
#include <string>
#include <vector>

namespace drydock::doctor {

/// A serial port of this machine, as /sys and /dev tell.
struct SerialPort {
  std::string path;    ///< /dev/ttyUSB0
  std::string by_id;   ///< the name that stays the same in every socket; empty: none
  std::string driver;  ///< ftdi_sio, cp210x, cdc_acm, ...
  std::string usb_id;  ///< 0403:6001; empty: not on USB
  std::string product;
};

/// A CAN network interface.
struct CanPort {
  std::string name;
  bool up = false, is_virtual = false;
  std::string state;  ///< of the controller
  std::optional<unsigned> bitrate;
};

/// Under `root`, "/" but in tests. Of the ports of a PC's chipset only those with hardware.
std::vector<SerialPort> serial_ports(const std::string& root);

/// Names by /sys; what the kernel says of each by netlink, where root is "/".
std::vector<CanPort> can_ports(const std::string& root);

}  // namespace drydock::doctor
