#pragma once

#include <string_view>

#include "drivers/live/services.hpp"

/// What a client of the page's fault services asks, as the order that `drydock fault` would send
/// for it: docs/use/live.md.
namespace drydock::cli {

/// {"device","fault","with":["KEY=VALUE",...],"for":"5s"}; with and for may be absent. Never
/// throws; fails with one line.
live::ServiceAnswer order_of_set_request(std::string_view request);

/// {"device","fault"}, both of which may be absent: all.
live::ServiceAnswer order_of_clear_request(std::string_view request);

}  // namespace drydock::cli
