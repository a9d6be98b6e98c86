#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

#include "drivers/link/descriptor.hpp"

namespace drydock::vcan {

/// The kernel's own slcan driver on a serial line (line discipline N_SLCAN, Linux 6.1), and the
/// adapter at the other end. While its channel is open, the adapter hears a water depth of 10 m
/// (PGN 128267) ten times a second.
class KernelSlcan {
 public:
  /// The kernel's end of the line and the adapter's.
  KernelSlcan(link::Descriptor kernels, link::Descriptor adapters);
  KernelSlcan(const KernelSlcan&) = delete;
  KernelSlcan& operator=(const KernelSlcan&) = delete;
  ~KernelSlcan();

  const std::string& interface() const { return interface_; }  ///< empty: the kernel has no slcan
  /// `ip link set INTERFACE up type can bitrate 250000 SETTINGS`; true if it is up.
  bool bring_up(const std::string& settings = {}) const;
  /// A line to the kernel, without its CR: "e1o" an overrun, "sp096130" error-passive with the
  /// receive and transmit errors. After "sb" (bus-off) it hears nothing until it is opened again.
  void say(std::string_view line);
  std::string commands() const;  ///< all lines of the kernel so far, each with its CR

 private:
  void serve();
  void obey(std::string_view command);

  link::Descriptor kernels_, adapters_;
  std::string interface_;
  mutable std::mutex mutex_;
  std::string commands_;
  std::atomic<bool> is_open_ = false, ends_ = false;
  std::thread adapter_;
};

/// On a line without hardware, a pty. When the object goes, the adapter is pulled out.
std::unique_ptr<KernelSlcan> slcan_on_pty();

/// The driver of a depth sensor streams from the interface and names what its controller tells.
void expect_every_state_is_named(KernelSlcan& slcan);
/// The driver names bus-off, and streams again when the interface was set down and up.
void expect_bus_off_ends(KernelSlcan& slcan);

}  // namespace drydock::vcan
