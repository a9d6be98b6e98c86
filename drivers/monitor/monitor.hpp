#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drivers/device/device.hpp"
#include "drivers/host/rig_viewer.hpp"
#include "rig_config/rig.hpp"

namespace drydock::monitor {

struct MonitorOptions {
  std::string link;          ///< URI
  std::string protocol;      ///< as in a rig file; empty: found by probing
  double duration_s = 0;     ///< 0: until Ctrl-C
  bool once = false;         ///< one table, as soon as every device streams, or after 10 s
  bool json = false;         ///< JSON Lines, one object a device, every second
  host::ServeOptions serve;  ///< for browsers too
};

/// Listens on a link and prints what it says: each message as a JSON line on standard output, a
/// line of counters on standard error every two seconds. Never writes to the wire.
/// Returns 0 when at least one message came, 1 when none did, 2 when the link could not be opened.
int monitor_messages(const MonitorOptions& options);

/// The sensors that probing finds on the link, as monitor_devices shows them. 1 when it finds none.
int monitor_link(const MonitorOptions& options);

/// A table of the devices, drawn over itself on a terminal, else JSON Lines or one table at the
/// end. The drivers only listen: nothing is written to a wire. `name` is what viewers read. Returns
/// 0 when all devices were streaming at the end, else 1.
int monitor_devices(std::vector<std::unique_ptr<device::Device>> devices, const std::string& name,
                    const MonitorOptions& options);

/// The same from the bus, for a rig whose drivers run in another process.
int monitor_bus(const rig_config::Rig& rig, const MonitorOptions& options);

}  // namespace drydock::monitor
