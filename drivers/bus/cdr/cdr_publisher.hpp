#pragma once

#include <memory>
#include <span>

#include "drivers/bus/cdr/cdr_sink.hpp"
#include "drivers/bus/device.hpp"

namespace drydock::bus {

/// Makes the messages of docs/build/bus.md for a sink: the bytes that DDS would carry, on the same
/// topics without `rt`. It ignores data of devices that are not in the list. One thread at a time.
class CdrPublisher {
 public:
  /// The sink must outlive it.
  CdrPublisher(CdrSink& sink, const std::vector<Device>& devices,
               const std::vector<std::string>& estimators,
               const std::vector<std::string>& navigators = {},  ///< they give Navigation too
               const std::vector<InnovationSource>& innovations = {});
  CdrPublisher(CdrPublisher&&) noexcept;
  CdrPublisher& operator=(CdrPublisher&&) noexcept;
  ~CdrPublisher();

  void publish(const Measurement& measurement);
  void publish(const Attitude& attitude, std::size_t estimator);
  void publish(const Navigation& navigation, std::size_t estimator);
  void publish(std::span<const DeviceStatus> health, Stamp now);
  void publish(const Innovation& innovation);
  /// `faults` are all faults in force now. A fault of the previous call that is missing has ended.
  void publish(std::span<const Fault> faults, Stamp now);

 private:
  struct Topics;
  std::unique_ptr<Topics> topics_;
};

}  // namespace drydock::bus
