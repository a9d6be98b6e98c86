#pragma once

#include <string>

/// The control of the machine in software (QMP), from inside it: with-ports.py.
namespace drydock::ports {

/// Pulls the USB serial adapter out, or puts it in again: "usb0" (ttyUSB0), "usb1" (ttyUSB1).
/// Returns the machine's answer, which is an error text if it refused.
std::string unplug(const std::string& adapter);
std::string plug(const std::string& adapter);

/// True if both adapters have a device file.
bool adapters_are_there();

}  // namespace drydock::ports
