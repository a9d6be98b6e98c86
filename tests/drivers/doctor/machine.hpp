#pragma once

#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "drivers/doctor/doctor.hpp"

namespace drydock::doctor {

/// A machine that consists of files: its /sys, /proc, /dev, /etc.
class Machine {
 public:
  Machine() {
    auto name = (std::filesystem::temp_directory_path() / "drydock-machine-XXXXXX").string();
    root_ = mkdtemp(name.data());
  }
  ~Machine() { std::filesystem::remove_all(root_); }
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  void file(const std::string& path, const std::string& text) {
    std::filesystem::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }
  void link(const std::string& path, const std::string& target) {
    std::filesystem::create_directories((root_ / path).parent_path());
    std::filesystem::create_symlink(target, root_ / path);
  }
  /// A USB serial adapter with an FTDI chip, as ttyUSB0.
  void plug_in() {
    file("sys/devices/usb1/1-2/idVendor", "0403\n");
    file("sys/devices/usb1/1-2/idProduct", "6001\n");
    file("sys/devices/usb1/1-2/product", "FT232R USB UART\n");
    file("sys/devices/usb1/1-2/ttyUSB0/port", "");
    file("sys/bus/usb-serial/drivers/ftdi_sio/module", "");
    link("sys/devices/usb1/1-2/ttyUSB0/driver", root() + "/sys/bus/usb-serial/drivers/ftdi_sio");
    link("sys/class/tty/ttyUSB0/device", root() + "/sys/devices/usb1/1-2/ttyUSB0");
    file("sys/bus/usb-serial/devices/ttyUSB0/latency_timer", "16\n");
    link("dev/serial/by-id/usb-FTDI_FT232R_A900-if00-port0", "../../ttyUSB0");
    file("dev/ttyUSB0", "");
    ::chmod((root() + "/dev/ttyUSB0").c_str(), 0660);
  }
  std::string root() const { return root_.string(); }

 private:
  std::filesystem::path root_;
};

/// What a rig of this port alone needs.
inline Needs rig_with(const std::string& port) {
  Needs needs;
  needs.whole_machine = false;
  needs.ports = {port};
  return needs;
}

}  // namespace drydock::doctor
