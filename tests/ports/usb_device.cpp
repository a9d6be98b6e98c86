#include "tests/ports/usb_device.hpp"

#include <gtest/gtest.h>

namespace drydock::ports {

UsbDevice::UsbDevice(const std::string& program)
    : orders_(::popen(
          ("exec python3 -B -S -E " DRYDOCK_SOURCE_DIR "/tests/ports/" + program + " >/dev/null")
              .c_str(),
          "w")) {
  order("plug");
}

UsbDevice::~UsbDevice() {
  order("unplug");
  EXPECT_EQ(::pclose(orders_), 0) << "the device in software ended with an error";
}

void UsbDevice::order(const std::string& line) {
  ASSERT_NE(orders_, nullptr);
  std::fprintf(orders_, "%s\n", line.c_str());
  std::fflush(orders_);
}

}  // namespace drydock::ports
