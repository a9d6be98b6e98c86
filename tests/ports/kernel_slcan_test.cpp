// An slcan adapter on USB with the kernel's own slcan driver on its serial port. It needs the
// machine for itself, since it takes the next free name of a CAN interface.
#include <fcntl.h>
#include <gtest/gtest.h>

#include "tests/ports/driver.hpp"
#include "tests/ports/machine.hpp"
#include "tests/vcan/kernel_slcan.hpp"
#include "tests/vcan/process.hpp"

namespace drydock::ports {
namespace {

using link::Descriptor;

Descriptor line(const char* path) {
  return Descriptor(::open(path, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
}

class KernelSlcan : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(vcan::run_program({"modprobe", "slcan"}), 0);
    ASSERT_TRUE(adapters_are_there());
    runs_on({"/dev/ttyUSB0"}, "tty/slcan");
    slcan = std::make_unique<vcan::KernelSlcan>(line("/dev/ttyUSB0"), line("/dev/ttyUSB1"));
    ASSERT_FALSE(slcan->interface().empty());
    ASSERT_TRUE(slcan->bring_up());
  }

  std::unique_ptr<vcan::KernelSlcan> slcan;
};

TEST_F(KernelSlcan, TellsEveryStateOfItsAdapterAndItsDriverNamesIt) {
  vcan::expect_every_state_is_named(*slcan);
}

TEST_F(KernelSlcan, ThatIsBusOffIsBroughtBackByDownAndUp) { vcan::expect_bus_off_ends(*slcan); }

}  // namespace
}  // namespace drydock::ports
