#pragma once

#include <cstdint>
#include <memory>

#include "drivers/bus/entity.hpp"

namespace drydock::bus {

/// How far the bus reaches. `this_host`: the loopback interface, no multicast, nothing leaves the
/// machine; a configuration in CYCLONEDDS_URI overrides it. `network`: Cyclone's own defaults.
enum class Reach : std::uint8_t { this_host, network };

/// Membership in a DDS domain (ROS_DOMAIN_ID of the ROS 2 nodes to talk with, 0 to 232).
class Participant {
 public:
  explicit Participant(std::uint32_t domain, Reach reach = Reach::this_host);

  std::int32_t handle() const { return participant_.handle(); }

 private:
  std::shared_ptr<Entity> domain_;  ///< shared by all participants of this process in the domain
  Entity participant_;
};

}  // namespace drydock::bus
