#pragma once

#include <string>
#include <string_view>

#include "hil/control/request/order_text.hpp"
#include "hil/fault/injector.hpp"

/// How a running bench obeys the orders that it receives.
namespace drydock::control {

/// Obeys one line and returns the answer:
/// {"ok":true,"lines":[...],"now_s","faults":[{"device","fault","words","since_s","until_s"}]}.
/// If the line is not an order, or cannot be obeyed, nothing changes: {"ok":false,"lines":[why]}.
std::string obey(std::string_view request, const rig_config::Rig& rig, fault::Injector& injector,
                 measurement::Stamp start, measurement::Stamp now);

}  // namespace drydock::control
