#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "drivers/bus/device.hpp"
#include "drivers/bus/participant.hpp"

namespace drydock::bus {

/// Receives the samples that a subscriber takes. A sample is valid only during the call.
class Receiver {
 public:
  virtual ~Receiver() = default;
  virtual void receive(const Measurement& measurement) = 0;
  virtual void receive(const Attitude& /*attitude*/, std::size_t /*estimator*/) {}
  virtual void receive(const DeviceStatus& /*status*/) {}
};

struct SubscriberOptions {
  std::vector<std::string> estimators;  ///< take `rt/estimate/<name>` of each
  bool diagnostics = false;             ///< take `rt/diagnostics`
  /// Take the samples of devices from writers of this participant alone. Another rig in the same
  /// domain may have devices of the same names.
  bool own_only = false;
};

/// Takes measurements from the bus on the caller's thread: wait until fd() is readable, then take.
class Subscriber {
 public:
  Subscriber(const Participant& participant, const std::vector<Device>& devices,
             const SubscriberOptions& options = {});
  Subscriber(Subscriber&&) noexcept;
  Subscriber& operator=(Subscriber&&) noexcept;
  ~Subscriber();

  /// Readable if something has arrived since the last take. The subscriber owns it: do not close it
  /// (an asio::posix::stream_descriptor on it must release() before it is destroyed).
  int fd() const;

  /// Empties every reader; samples of one topic come in order. Returns the number of samples given
  /// to the receiver.
  std::size_t take(Receiver& receiver);

  /// Does the same for measurements only.
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

  /// Connections with writers, summed over all topics. 0 means that nobody publishes yet.
  std::size_t matched_writers() const;

  std::uint64_t unusable() const;  ///< samples whose content cannot be a measurement
  std::uint64_t foreign() const;   ///< samples of other participants that were not taken

 private:
  struct Readers;
  std::unique_ptr<Readers> readers_;
};

}  // namespace drydock::bus
