#pragma once

#include <optional>
#include <vector>

#include "drivers/bus/device.hpp"
#include "estimators/pipeline/listener.hpp"

namespace drydock::host {

/// Estimates as the bus has them.
bus::Attitude bus_attitude(const pipeline::AttitudeEstimate& estimate);
bus::Innovation bus_innovation(const pipeline::InnovationReport& report);

/// Positions besides as offsets, each estimator's from its first.
class BusNavigation {
 public:
  bus::Navigation operator()(const pipeline::NavigationEstimate& estimate);

 private:
  std::vector<std::optional<frame::Position>> origins_;
};

}  // namespace drydock::host
