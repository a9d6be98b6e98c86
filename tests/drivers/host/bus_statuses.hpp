#pragma once

#include <poll.h>

#include <chrono>
#include <string>
#include <vector>

#include "drivers/bus/subscriber.hpp"
#include "drivers/host/rig_publisher.hpp"
#include "tests/own_domain.hpp"

namespace drydock::host::test {

inline std::vector<bus::Device> one_device(const std::string& name, bus::Kind kind) {
  std::vector<bus::Device> devices(1);
  devices[0].name = name;
  devices[0].kind = kind;
  return devices;
}

inline bus::SubscriberOptions diagnostics_alone() {
  bus::SubscriberOptions wanted;
  wanted.diagnostics = true;
  return wanted;
}

/// A rig of one device that publishes, and somebody who hears its diagnostics.
struct OneDeviceOnTheBus final : private bus::Receiver {
  OneDeviceOnTheBus(const std::string& name, bus::Kind kind) : devices(one_device(name, kind)) {}

  /// Calls `publish` again and again until a status comes, or patience is over: a reader that
  /// DDS has not found yet hears nothing.
  template <class Publish>
  std::vector<bus::DeviceStatus> heard_after(Publish publish) {
    statuses.clear();
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{30};
    while (statuses.empty() && std::chrono::steady_clock::now() < end) {
      publish();
      pollfd readable{subscriber.fd(), POLLIN, 0};
      ::poll(&readable, 1, 50);
      subscriber.take(*this);
    }
    return statuses;
  }

  std::vector<bus::Device> devices;
  bus::Participant participant{drydock::test::own_domain(), "lo"};
  RigPublisher publisher{participant, devices};
  bus::Subscriber subscriber{participant, devices, diagnostics_alone()};

 private:
  using bus::Receiver::receive;
  void receive(const bus::Measurement&) override {}
  void receive(const bus::DeviceStatus& status) override { statuses.push_back(status); }
  std::vector<bus::DeviceStatus> statuses;
};

}  // namespace drydock::host::test
