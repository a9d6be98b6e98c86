#include "estimators/host/diagnostician_beside.hpp"

#include "estimators/host/diagnostician.hpp"

namespace drydock::host {

std::shared_ptr<Follower> diagnostician_beside(const rig_config::Rig& rig,
                                               std::vector<const device::Device*> devices,
                                               Follower& others) {
  auto made = std::make_shared<Diagnostician>(rig, others);
  made->watch(std::move(devices));
  return made;
}

}  // namespace drydock::host
