#pragma once

#include <string>
#include <string_view>

namespace drydock::terminal {

/// Tells systemd how a service is: the protocol of sd_notify(3), a datagram of KEY=VALUE to the
/// socket that $NOTIFY_SOCKET names. Without that variable it does nothing. Never blocks.
class ServiceManager {
 public:
  ServiceManager();  ///< reads the environment
  ~ServiceManager();
  ServiceManager(const ServiceManager&) = delete;
  ServiceManager& operator=(const ServiceManager&) = delete;

  void ready() const { tell("READY=1"); }
  void alive() const { tell("WATCHDOG=1"); }  ///< for WatchdogSec=, from the loop that works
  void stopping() const { tell("STOPPING=1"); }

 private:
  void tell(std::string_view text) const;

  int socket_ = -1;
};

}  // namespace drydock::terminal
