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
  link::Uri real;                   ///< opened as a driver does
  link::Uri virt;                   ///< opened as a device does; carries what `real` carries
  rig_config::DeviceConfig device;  ///< name, protocol (may be empty), address, link
  std::shared_ptr<fault::Schedule> schedule;  ///< may be edited while it runs: then rearm()
  std::uint64_t seed = 1;
  std::function<void(const std::string&)> say;  ///< one line a change of either side
};

/// What went through: bytes, of a bus frames.
struct Passed {
  std::uint64_t from_device = 0, to_drivers = 0, from_drivers = 0, to_device = 0;
  std::uint64_t lost = 0;  ///< not taken by the other side
};

/// A real device's link passed on to a virtual one, faults between. Without a fault in force that
/// is about messages every read is written on at once. The virtual side is there while the real
/// one is and no fault has unplugged it. Everything runs on the thread of the io_context.
class Proxy {
 public:
  /// Starts with the io_context; `io` outlives it.
  static std::unique_ptr<Proxy> start(boost::asio::io_context& io, ProxyOptions options);

  Proxy() = default;
  Proxy(const Proxy&) = delete;
  Proxy& operator=(const Proxy&) = delete;
  virtual ~Proxy() = default;

  /// Closes both sides; the io_context then runs out of work.
  virtual void finish() = 0;
  /// To be called after the schedule was edited.
  virtual void rearm() = 0;

  virtual Passed passed() const = 0;
  virtual fault::FaultHits hits() const = 0;
  /// From a read's return to the return of the write that passed it on.
  virtual const Latency& latency() const = 0;
};

/// Where drivers and other programs find the virtual side, in words.
std::string place_of(const link::Uri& virt);

}  // namespace drydock::proxy
