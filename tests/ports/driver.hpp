#pragma once

#include <string>
#include <vector>

namespace drydock::ports {

/// The kernel's bus and driver of a port ("/dev/ttyUSB0") or a CAN interface ("can0"), as sysfs
/// names them: "usb-serial/ftdi_sio", "pnp/serial" for a 16550A. Empty: there is none.
std::string kernel_driver(const std::string& port);

/// Writes the drivers of these into the report of the test that runs, for the table that
/// with-ports.py prints. `more`: a driver without a device in sysfs.
void runs_on(const std::vector<std::string>& ports, const std::string& more = {});

}  // namespace drydock::ports
