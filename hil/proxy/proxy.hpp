#pragma once

#include <boost/asio/io_context.hpp>
#include <functional>
#include <memory>
#include <string>

#include "drivers/link/uri.hpp"
#include "hil/fault/fault_hits.hpp"
#include "hil/fault/schedule/schedule.hpp"
#include "hil/proxy/latency.hpp"
#include "rig_config/rig.hpp"

namespace drydock::proxy {

struct ProxyOptions {
  link::Uri real;                   ///< opened like a driver opens it
  link::Uri virt;                   ///< opened like a device opens it; carries the same as `real`
  rig_config::DeviceConfig device;  ///< name, protocol (may be empty), address, link
  /// In times of link::steady_now(). After an edit during the run, call rearm().
  std::shared_ptr<fault::Schedule> schedule;
  std::uint64_t seed = 1;
  std::function<void(const std::string&)> say;  ///< gets one line per change of either side
};

/// Amounts that passed: bytes, or frames of a bus.
struct Passed {
  std::uint64_t from_device = 0, to_drivers = 0, from_drivers = 0, to_device = 0;
  std::uint64_t lost = 0;  ///< the other side did not take it
};

/// Connects a real device's link to a virtual one, with faults between them. While no fault on
/// messages is in force, every read is written at once. The virtual side exists while the real one
/// does and no fault has unplugged it. Everything runs on the thread of the io_context.
class Proxy {
 public:
  /// Starts with the io_context; `io` must outlive the proxy.
  static std::unique_ptr<Proxy> start(boost::asio::io_context& io, ProxyOptions options);

  Proxy() = default;
  Proxy(const Proxy&) = delete;
  Proxy& operator=(const Proxy&) = delete;
  virtual ~Proxy() = default;

  /// Closes both sides; the io_context then runs out of work.
  virtual void finish() = 0;
  /// Call it after an edit of the schedule.
  virtual void rearm() = 0;

  virtual Passed passed() const = 0;
  virtual fault::FaultHits hits() const = 0;
  /// From the return of a read to the return of the write that passed it on.
  virtual const Latency& latency() const = 0;
};

/// Where drivers and other programs find the virtual side, in words.
std::string place_of(const link::Uri& virt);

}  // namespace drydock::proxy
