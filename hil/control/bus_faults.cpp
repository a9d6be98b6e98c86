#include "hil/control/bus_faults.hpp"

namespace drydock::control {

std::vector<bus::Fault> bus_faults(const std::vector<fault::FaultNow>& faults) {
  std::vector<bus::Fault> all;
  all.reserve(faults.size());
  for (const fault::FaultNow& f : faults)
    all.push_back({f.device, f.name, f.words, f.since, f.until});
  return all;
}

}  // namespace drydock::control
