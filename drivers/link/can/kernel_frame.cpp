#include "drivers/link/can/kernel_frame.hpp"

#include <algorithm>
#include <cstddef>

namespace drydock::link {

// By design a classic frame can be read through canfd_frame.
static_assert(offsetof(can_frame, can_id) == offsetof(canfd_frame, can_id));
static_assert(offsetof(can_frame, len) == offsetof(canfd_frame, len));
static_assert(offsetof(can_frame, data) == offsetof(canfd_frame, data));

KernelFrame to_kernel(const wire::CanFrame& frame) {
  KernelFrame kernel;
  kernel.size = frame.fd ? CANFD_MTU : CAN_MTU;
  kernel.frame.can_id = frame.id;
  if (frame.extended) kernel.frame.can_id |= CAN_EFF_FLAG;
  if (frame.remote) kernel.frame.can_id |= CAN_RTR_FLAG;
  if (frame.error) kernel.frame.can_id |= CAN_ERR_FLAG;
  if (frame.bit_rate_switch) kernel.frame.flags |= CANFD_BRS;
  kernel.frame.len = frame.size;
  std::copy_n(frame.data.begin(), frame.size, kernel.frame.data);
  return kernel;
}

wire::CanFrame from_kernel(const KernelFrame& kernel) {
  wire::CanFrame frame;
  const canid_t id = kernel.frame.can_id;
  frame.error = (id & CAN_ERR_FLAG) != 0;
  frame.extended = !frame.error && (id & CAN_EFF_FLAG) != 0;
  frame.remote = !frame.error && (id & CAN_RTR_FLAG) != 0;
  frame.id = id & (frame.error || frame.extended ? CAN_EFF_MASK : CAN_SFF_MASK);
  frame.fd = kernel.size == CANFD_MTU;
  frame.bit_rate_switch = frame.fd && (kernel.frame.flags & CANFD_BRS) != 0;
  const std::size_t longest = frame.fd ? CANFD_MAX_DLEN : CAN_MAX_DLEN;
  frame.size = static_cast<std::uint8_t>(std::min<std::size_t>(kernel.frame.len, longest));
  if (!frame.remote) std::copy_n(kernel.frame.data, frame.size, frame.data.begin());
  return frame;
}

}  // namespace drydock::link
