#pragma once

#include <string>

/// What a person types so that a CAN interface of the kernel does what a link needs. A controller
/// takes settings only while it is down, so each command works whatever the interface does now.
namespace drydock::link {

/// `bit_rate` in bit/s. `root` is "/" except in tests: its /sys names the controller's driver.
std::string command_to_set_up(const std::string& name, unsigned bit_rate,
                              const std::string& root = "/");
/// The same with CAN FD; `data_rate` in bit/s.
std::string command_to_set_up_fd(const std::string& name, unsigned bit_rate, unsigned data_rate);
/// Ends bus-off; the settings stay.
std::string command_to_restart(const std::string& name);
/// The controller then sends nothing, not even an acknowledgement.
std::string command_to_listen_only(const std::string& name);
std::string command_to_set_up_virtual(const std::string& name);

}  // namespace drydock::link
