#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "drivers/bus/device.hpp"
#include "drivers/bus/participant.hpp"

namespace drydock::bus {

/// Receives what a subscriber takes. Nothing is kept after the call.
class Receiver {
 public:
  virtual ~Receiver() = default;
  virtual void receive(const Measurement& measurement) = 0;
  virtual void receive(const Attitude& /*attitude*/, std::size_t /*estimator*/) {}
  virtual void receive(const DeviceStatus& /*status*/) {}
};

struct SubscriberOptions {
  std::vector<std::string> estimators;  ///< take `rt/estimate/<name>` of these
  bool diagnostics = false;             ///< take `rt/diagnostics`
};

/// Takes measurements from the bus on the caller's thread: wait until fd() is readable, then take.
class Subscriber {
 public:
  Subscriber(const Participant& participant, const std::vector<Device>& devices,
             const SubscriberOptions& options = {});
  Subscriber(Subscriber&&) noexcept;
  Subscriber& operator=(Subscriber&&) noexcept;
  ~Subscriber();

  /// Readable when something arrived since the last take. Owned by the subscriber: do not close it
  /// (an asio::posix::stream_descriptor on it must release() before it is destroyed).
  int fd() const;

  /// Drains every reader; in order per topic. Returns how many samples were handed over.
  std::size_t take(Receiver& receiver);

  /// The same for measurements only.
  template <class OnMeasurement>
  std::size_t take_measurements(OnMeasurement on_measurement) {
    struct Adapter final : Receiver {
      explicit Adapter(OnMeasurement& f) : call(f) {}
      using Receiver::receive;
      void receive(const Measurement& measurement) override { call(measurement); }
      OnMeasurement& call;
    } adapter{on_measurement};
    return take(adapter);
  }

  /// Connections with writers, over all topics: 0 means nobody publishes yet.
  std::size_t matched_writers() const;

  std::uint64_t unusable() const;  ///< samples whose content cannot be a measurement

 private:
  struct Readers;
  std::unique_ptr<Readers> readers_;
};

}  // namespace drydock::bus
