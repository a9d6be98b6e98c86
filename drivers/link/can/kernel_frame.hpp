#pragma once

#include <linux/can.h>

#include "drivers/wire/can/can_frame.hpp"

namespace drydock::link {

/// A frame in the kernel's layout. A classic frame is the first CAN_MTU bytes of the structure.
struct KernelFrame {
  canfd_frame frame{};
  std::size_t size = CAN_MTU;  ///< CAN_MTU or CANFD_MTU
};

KernelFrame to_kernel(const wire::CanFrame& frame);
wire::CanFrame from_kernel(const KernelFrame& kernel);

}  // namespace drydock::link
