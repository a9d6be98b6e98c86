#include "drivers/link/can/can_auto.hpp"

#include <map>
#include <mutex>

#include "drivers/link/can/can_interface.hpp"
#include "drivers/link/can/slcan.hpp"
#include "drivers/link/can/slcan_port.hpp"
#include "drivers/link/can/socketcan.hpp"
#include "drivers/link/serial/pty.hpp"
#include "drivers/link/serial/serial.hpp"

namespace drydock::link {
namespace {

bool is_ready(const boost::system::result<CanInterface>& found) {
  return found && found->is_vcan && found->up;
}

/// True if a vcan interface of that name is up. Makes it or brings it up if the process may.
bool make_ready(const std::string& name) {
  auto found = find_can_interface(name);
  if (!found && !create_vcan(name)) found = find_can_interface(name);
  if (found && found->is_vcan && !found->up && !set_interface_up(name, true))
    found = find_can_interface(name);
  return is_ready(found);
}

Uri pty_uri(const std::string& name) { return parse_uri("pty:" + name).value(); }

/// Emulated buses of this process: several devices may open the same one.
OpenedFrames join_slcan_bus(const asio::any_io_executor& executor, const std::string& name) {
  static std::mutex mutex;
  static std::map<std::string, std::weak_ptr<SlcanBus>> by_name;
  const std::lock_guard lock(mutex);
  std::shared_ptr<SlcanBus> bus = by_name[name].lock();
  if (!bus) {
    std::vector<std::unique_ptr<ByteLink>> lines;
    for (const std::string& end : {name, name + "-tap"}) {
      auto line = open_pty_device(executor, pty_uri(end));
      if (!line) return line.error();
      lines.push_back(std::move(*line));
    }
    by_name[name] = bus = SlcanBus::open(executor, std::move(lines));
  }
  return bus->join();
}

OpenedFrames open_vcan(const asio::any_io_executor& executor, const Uri& uri) {
  Uri interface = parse_uri("socketcan:" + uri.target).value();
  interface.query["emulated"] = "1";
  return open_socketcan(executor, interface);
}

OpenedFrames open_slcan_pty(const asio::any_io_executor& executor, const Uri& uri) {
  auto line = open_pty_driver(executor, pty_uri(uri.target));
  if (!line) return line.error();
  return make_slcan(executor, std::move(*line), {*uri.bitrate(), uri.only_listens(), false});
}

}  // namespace

OpenedFrames open_can_auto(const asio::any_io_executor& executor, const Uri& uri, Side side) {
  const auto found = find_can_interface(uri.target);
  if (found && !found->is_vcan)
    return OpenError{system_error(EEXIST),
                     uri.target + " is a real CAN interface: can:auto takes " +
                         "only vcan; write socketcan:" + uri.target + " or another name"};
  if (side == Side::driver)
    return is_ready(found) ? open_vcan(executor, uri) : open_slcan_pty(executor, uri);
  if (make_ready(uri.target)) return open_vcan(executor, uri);
  return join_slcan_bus(executor, uri.target);
}

std::string can_auto_level(const Uri& uri) {
  if (is_ready(find_can_interface(uri.target))) return uri.target + " of the kernel";
  return "slcan on the pty " + pty_path(uri.target);
}

}  // namespace drydock::link
