#pragma once

#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cstdint>

namespace drydock::consistency {

/// The devices whose values make one residual, by index in the rig.
using Devices = boost::container::static_vector<std::uint16_t, 4>;

inline bool contains(const Devices& devices, std::uint16_t device) {
  return std::find(devices.begin(), devices.end(), device) != devices.end();
}

inline void add(Devices& devices, std::uint16_t device) {
  if (!contains(devices, device) && devices.size() < devices.capacity()) devices.push_back(device);
}

}  // namespace drydock::consistency
