#pragma once

#include <string_view>

#include "drivers/live/foxglove/services.hpp"

/// Turns a request to the page's fault services into the order that `drydock fault` would send:
/// docs/use/live.md.
namespace drydock::control {

/// Request: {"device","fault","with":["KEY=VALUE",...],"for":"5s"}; `with` and `for` are optional.
/// Never throws; fails with one line.
live::ServiceAnswer order_of_set_request(std::string_view request);

/// Request: {"device","fault"}; both are optional. A missing key means all.
live::ServiceAnswer order_of_clear_request(std::string_view request);

}  // namespace drydock::control
