#pragma once

#include <cstdio>
#include <string>

namespace drydock::ports {

/// A USB device in software (usb_device.py), behind one of the kernel's drivers. It obeys orders;
/// the destructor pulls it out.
class UsbDevice {
 public:
  /// "usb_can.py gs_usb" gives can2 and can3, "usb_can.py usb_8dev" can2, "usb_serial.py" a ttyUSB.
  explicit UsbDevice(const std::string& program);
  UsbDevice(const UsbDevice&) = delete;
  UsbDevice& operator=(const UsbDevice&) = delete;
  ~UsbDevice();

  void order(const std::string& line);

 private:
  std::FILE* orders_;
};

}  // namespace drydock::ports
