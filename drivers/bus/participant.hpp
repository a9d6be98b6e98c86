#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "drivers/bus/entity.hpp"

namespace drydock::bus {

/// Nothing leaves or enters the machine through this interface.
inline constexpr const char* loopback_interface = "lo";

/// Membership in a DDS domain on one network interface. The domain is the ROS_DOMAIN_ID of the ROS
/// 2 nodes to talk with, 0 to 232. On loopback it uses unicast, on any other interface multicast,
/// which is Cyclone's default. A configuration in CYCLONEDDS_URI replaces all this. A process can
/// use a domain through one interface only.
class Participant {
 public:
  explicit Participant(std::uint32_t domain, const std::string& interface = loopback_interface);

  std::int32_t handle() const { return participant_.handle(); }

 private:
  std::shared_ptr<Entity> domain_;  ///< shared by all participants of this process in the domain
  Entity participant_;
};

}  // namespace drydock::bus
