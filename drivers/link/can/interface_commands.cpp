#include "drivers/link/can/interface_commands.hpp"

#include <filesystem>

namespace drydock::link {
namespace {

std::string down_then_up(const std::string& name, const std::string& settings) {
  const std::string set = "sudo ip link set " + name;
  return set + " down; " + set + " up" + (settings.empty() ? "" : " type can " + settings);
}

std::string at(unsigned bit_rate) { return "bitrate " + std::to_string(bit_rate); }

/// Linux 6.1 refuses restart-ms where a driver cannot restart its controller (do_set_mode of
/// can_priv); of the drivers of adapters that is gs_usb alone.
bool restarts_itself(const std::string& name, const std::string& root) {
  namespace fs = std::filesystem;
  std::error_code none;
  const auto driver =
      fs::read_symlink(fs::path(root) / "sys/class/net" / name / "device/driver", none);
  return driver.filename() != "gs_usb";
}

}  // namespace

std::string command_to_set_up(const std::string& name, unsigned bit_rate, const std::string& root) {
  return down_then_up(name, at(bit_rate) + (restarts_itself(name, root) ? " restart-ms 100" : ""));
}

std::string command_to_set_up_fd(const std::string& name, unsigned bit_rate, unsigned data_rate) {
  return down_then_up(name, at(bit_rate) + " d" + at(data_rate) + " fd on");
}

std::string command_to_restart(const std::string& name) { return down_then_up(name, {}); }

std::string command_to_listen_only(const std::string& name) {
  return down_then_up(name, "listen-only on");
}

std::string command_to_set_up_virtual(const std::string& name) {
  return "sudo ip link set " + name + " up";
}

}  // namespace drydock::link
