#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "drivers/link/opening.hpp"

/// CAN network interfaces of the kernel, through rtnetlink.
namespace drydock::link {

struct CanInterface {
  int index = 0;
  bool up = false;
  bool is_vcan = false;
  unsigned mtu = 0;                 ///< 16: classic CAN; 72: CAN FD
  std::optional<unsigned> bitrate;  ///< nominal phase, bit/s; empty if the driver has no rate
  std::optional<bool> listen_only;  ///< the controller sends nothing, not even an acknowledgement
  /// State of the controller, in the kernel's words: "ERROR-ACTIVE" ... "BUS-OFF". Empty if it is
  /// not known.
  std::string_view state;
};

/// The kernel's data of the interface. Fails with ENODEV if it does not exist or is not CAN.
boost::system::result<CanInterface> find_can_interface(const std::string& name);

/// Makes a vcan interface that carries CAN FD and brings it up. EPERM without CAP_NET_ADMIN,
/// EOPNOTSUPP if the kernel has no vcan.
ErrorCode create_vcan(const std::string& name);

/// Sets an interface up or down. EPERM without CAP_NET_ADMIN.
ErrorCode set_interface_up(const std::string& name, bool up);

}  // namespace drydock::link
