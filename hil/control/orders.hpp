#pragma once

#include <string>
#include <string_view>

#include "hil/control/request/order_text.hpp"
#include "hil/fault/injector.hpp"

/// What a running bench makes of the orders that it hears.
namespace drydock::control {

/// Does what a line asks and says what became of it:
/// {"ok":true,"lines":[...],"now_s","faults":[{"device","fault","words","since_s","until_s"}]}. A
/// line that is no order, or that cannot be obeyed, changes nothing: {"ok":false,"lines":[why]}.
std::string obey(std::string_view request, const rig_config::Rig& rig, fault::Injector& injector,
                 measurement::Stamp start, measurement::Stamp now);

}  // namespace drydock::control
