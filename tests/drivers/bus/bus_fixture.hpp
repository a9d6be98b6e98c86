#pragma once

#include <poll.h>

#include <chrono>
#include <vector>

#include "drivers/bus/publisher.hpp"
#include "drivers/bus/subscriber.hpp"

namespace drydock::bus::test {

using measurement::stamp_from_ns;

/// A domain that only this process uses, so that parallel tests do not meet.
std::uint32_t test_domain();

/// Patience with a busy machine: nothing waits so long unless it fails.
constexpr std::chrono::seconds patience{30};

/// True as soon as `condition` is true. False when patience is over.
template <class Condition>
bool eventually(Condition condition) {
  const auto end = std::chrono::steady_clock::now() + patience;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    ::poll(nullptr, 0, 1);
  }
  return true;
}

/// Waits on fd() until `count` measurements have come, or until `patience` passes without one.
std::vector<Measurement> take(Subscriber& subscriber, std::size_t count);

/// The rig of these tests: one device of every kind, in this order.
enum Index : std::uint16_t { dvl, log, gnss, imu, depth, actuator, compass };
std::vector<Device> all_devices(Provenance provenance = Provenance::emulated,
                                Form form = Form::complete);

/// An origin whose times use every digit of the nanoseconds.
measurement::Origin origin(Index device);

/// A sample without any value from the device.
template <class Sample>
Sample only_origin(Index device) {
  Sample sample;
  sample.origin = origin(device);
  return sample;
}

}  // namespace drydock::bus::test
