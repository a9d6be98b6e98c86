#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "drivers/bus/entity.hpp"

namespace drydock::bus {

/// The interface that nothing leaves the machine by, and nothing enters.
inline constexpr const char* loopback_interface = "lo";

/// Membership in a DDS domain (ROS_DOMAIN_ID of the ROS 2 nodes to talk with, 0 to 232), on one
/// network interface: on loopback by unicast, on any other with multicast as Cyclone does by
/// default. A configuration in CYCLONEDDS_URI takes the place of all this. A process can be in a
/// domain by one interface only.
class Participant {
 public:
  explicit Participant(std::uint32_t domain, const std::string& interface = loopback_interface);

  std::int32_t handle() const { return participant_.handle(); }

 private:
  std::shared_ptr<Entity> domain_;  ///< shared by all participants of this process in the domain
  Entity participant_;
};

}  // namespace drydock::bus
