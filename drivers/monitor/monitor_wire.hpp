#pragma once

#include "drivers/link/uri.hpp"
#include "drivers/monitor/monitor.hpp"

namespace drydock::monitor {

/// The frames of one protocol on a link that is only listened to, on the screen of this terminal:
/// hex, fields, and what changed. Returns 0 if at least one frame came, 1 if none came, 2 if the
/// link could not be opened.
int monitor_wire(const MonitorOptions& options, const link::Uri& uri, link::Carries carries);

}  // namespace drydock::monitor
