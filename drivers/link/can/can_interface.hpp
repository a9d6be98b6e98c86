#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "drivers/link/opening.hpp"

/// CAN network interfaces of the kernel, by rtnetlink.
namespace drydock::link {

struct CanInterface {
  int index = 0;
  bool up = false;
  bool is_vcan = false;
  unsigned mtu = 0;                 ///< 16: classic CAN; 72: CAN FD
  std::optional<unsigned> bitrate;  ///< nominal phase, bit/s; empty where the driver has none
  /// Of the controller, in the kernel's words: "ERROR-ACTIVE" ... "BUS-OFF"; empty: none is told.
  std::string_view state;
};

/// The kernel's name for the interface; fails with ENODEV when there is none or it is not CAN.
boost::system::result<CanInterface> find_can_interface(const std::string& name);

/// Makes a vcan interface that carries CAN FD and brings it up. EPERM without CAP_NET_ADMIN,
/// EOPNOTSUPP where the kernel has no vcan.
ErrorCode create_vcan(const std::string& name);

/// Sets an interface up or down. EPERM without CAP_NET_ADMIN.
ErrorCode set_interface_up(const std::string& name, bool up);

}  // namespace drydock::link
