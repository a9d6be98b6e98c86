#pragma once

#include <cstdio>
#include <string>

namespace drydock::ports {

/// A USB CAN adapter in software (usb_can.py), for one of the kernel's drivers: "gs_usb" gives can2
/// and can3, "usb_8dev" can2. It obeys orders; the destructor pulls it out.
class UsbCan {
 public:
  explicit UsbCan(const std::string& driver);
  UsbCan(const UsbCan&) = delete;
  UsbCan& operator=(const UsbCan&) = delete;
  ~UsbCan();

  void order(const std::string& line);

 private:
  std::FILE* orders_;
};

}  // namespace drydock::ports
