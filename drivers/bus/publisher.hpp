#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "drivers/bus/device.hpp"
#include "drivers/bus/participant.hpp"

namespace drydock::bus {

struct TopicCounters {
  std::string topic;
  std::uint64_t written = 0;
  /// Samples written while a reader still owed more acknowledgements than the writer keeps samples.
  /// Such a reader stalls and may have lost that many samples. Readers that keep up lose nothing.
  std::uint64_t overrun = 0;
  std::uint64_t dropped = 0;  ///< not sent: a stalled reader filled the queue (time-out)
  std::uint64_t failed = 0;   ///< DDS refused them for any other reason
};

/// Puts measurements, estimates and health on the bus. Only wait_for_readers() waits. Never throws
/// after construction. One thread at a time.
class Publisher {
 public:
  Publisher(const Participant& participant, const std::vector<Device>& devices,
            const std::vector<std::string>& estimators = {},
            const std::vector<std::string>& navigators = {});  ///< they give Navigation too
  Publisher(Publisher&&) noexcept;
  Publisher& operator=(Publisher&&) noexcept;
  ~Publisher();

  /// Writes to the topics of device `origin.device`. Counts in misrouted() if there is no such
  /// device, if its kind does not give such a measurement, or if its provenance is not the declared
  /// one.
  void publish(const Measurement& measurement);

  /// To `rt/estimate/<estimators[estimator]>`; an unknown index counts in misrouted().
  void publish(const Attitude& attitude, std::size_t estimator);

  /// To `rt/estimate/<name>/odometry` and `/fix`. An estimator that is no navigator counts in
  /// misrouted().
  void publish(const Navigation& navigation, std::size_t estimator);

  void publish(std::span<const DeviceStatus> health, Stamp now);

  /// Connections with readers, summed over all topics. 0 means that nobody listens yet.
  std::size_t matched_readers() const;

  /// Waits until all readers have all that was published; `longest` for each topic. False: one has
  /// not.
  bool wait_for_readers(std::chrono::nanoseconds longest) const;

  std::vector<TopicCounters> counters() const;
  std::uint64_t misrouted() const;

 private:
  struct Writers;
  std::unique_ptr<Writers> writers_;
};

}  // namespace drydock::bus
