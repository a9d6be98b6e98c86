#pragma once

#include <string>
#include <vector>

#include "estimators/external/hello.hpp"
#include "hil/steer/joint.hpp"

namespace drydock::steer {

/// What a program that steers is told before the first step: the rig, the joints that it may order
/// with their limits, the devices whose measurements it gets. One line of JSON, without its end.
std::string hello_of(const std::string& rig, double step_s, const std::vector<Joint>& joints,
                     const std::vector<external::Hello::Device>& devices);

}  // namespace drydock::steer
