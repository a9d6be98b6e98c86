#include "tests/ports/usb_can.hpp"

#include <gtest/gtest.h>

namespace drydock::ports {

UsbCan::UsbCan(const std::string& driver)
    : orders_(::popen(("exec python3 -B -S -E " DRYDOCK_SOURCE_DIR "/tests/ports/usb_can.py " +
                       driver + " >/dev/null")
                          .c_str(),
                      "w")) {
  order("plug");
}

UsbCan::~UsbCan() {
  order("unplug");
  EXPECT_EQ(::pclose(orders_), 0) << "the adapter in software ended with an error";
}

void UsbCan::order(const std::string& line) {
  ASSERT_NE(orders_, nullptr);
  std::fprintf(orders_, "%s\n", line.c_str());
  std::fflush(orders_);
}

}  // namespace drydock::ports
