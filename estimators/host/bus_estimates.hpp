#pragma once

#include <optional>
#include <vector>

#include "drivers/bus/device.hpp"
#include "estimators/pipeline/listener.hpp"

namespace drydock::host {

/// Converts estimates to the types of the bus.
bus::Attitude bus_attitude(const pipeline::AttitudeEstimate& estimate);
bus::Innovation bus_innovation(const pipeline::InnovationReport& report);

/// Converts navigation estimates to the type of the bus. Adds the offset of each position from the
/// first position of the same estimator.
class BusNavigation {
 public:
  bus::Navigation operator()(const pipeline::NavigationEstimate& estimate);

 private:
  std::vector<std::optional<frame::Position>> origins_;
};

}  // namespace drydock::host
