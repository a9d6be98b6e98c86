#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drivers/device/device.hpp"
#include "drivers/host/beside.hpp"
#include "drivers/host/rig_viewer.hpp"
#include "drivers/monitor/values/display_units.hpp"
#include "rig_config/rig.hpp"

namespace drydock::monitor {

struct MonitorOptions {
  std::string link;      ///< URI
  std::string protocol;  ///< as in a rig file; empty: probing finds it
  std::shared_ptr<const wire::described::Description> description{};  ///< of `protocol`, if a file
  double duration_s = 0;                                              ///< 0: until Ctrl-C
  bool once = false;         ///< one table, when all is well, or after 10 s
  bool start = false;        ///< CANopen nodes are started, as their drivers do
  bool json = false;         ///< JSON Lines, one object for each device, every second
  DisplayUnits units;        ///< of the values, for a person
  host::ServeOptions serve;  ///< shows it to browsers too
  host::Beside beside;       ///< says what is wrong with the devices; may be empty
};

/// Listens on a link and shows its frames on a terminal's screen; elsewhere it prints its messages:
/// each message as a JSON line on standard output, a line of counters on standard error every two
/// seconds. It never writes to the wire. Returns 0 if at least one message came, 1 if none came, 2
/// if the link could not be opened.
int monitor_messages(const MonitorOptions& options);

/// Probes the link and shows the sensors that it finds, as monitor_devices does. Returns 1 if it
/// finds none.
int monitor_link(const MonitorOptions& options);

/// Shows a table of the devices: on a terminal drawn over itself, otherwise as JSON Lines or as one
/// table at the end. The drivers only listen: nothing is written to a wire. Viewers show the
/// name of the rig.
/// Returns 0 if nothing was wrong with any device at the end, else 1 (problems.hpp).
int monitor_devices(std::vector<std::unique_ptr<device::Device>> devices,
                    const rig_config::Rig& rig, const MonitorOptions& options);

/// Shows the same from the bus, for a rig whose drivers run in another process.
int monitor_bus(const rig_config::Rig& rig, const MonitorOptions& options);

}  // namespace drydock::monitor
