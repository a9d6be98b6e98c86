#pragma once

#include <functional>
#include <string>
#include <vector>

#include "drivers/live/foxglove/services.hpp"
#include "rig_config/rig.hpp"

namespace drydock::control {

class LiveFaults;

/// Obeys one order of order_text.hpp. `answered` gets the answer line, at once or later.
using Obey =
    std::function<void(const std::string& order, std::function<void(const std::string&)> answered)>;

/// Fault services for viewers of a run: /drydock/faults/set, clear, list and words. Throws
/// std::runtime_error with one line if no device of the rig is emulated.
std::vector<live::Service> fault_services(const rig_config::Rig& rig, const Obey& obey);
std::vector<live::Service> fault_services(const rig_config::Rig& rig, LiveFaults& faults);

}  // namespace drydock::control
