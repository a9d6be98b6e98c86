#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/bus/device.hpp"

namespace drydock::bus {

/// Whose measurements stand on a topic.
struct MeasurementTopic {
  std::string device;
  Kind kind = Kind::imu;
};

/// Of the topics of docs/build/bus.md, without `rt`, the one of each device that loses no field:
/// "/imu/data", "/dvl/bottom_track". Empty: another topic.
std::optional<MeasurementTopic> measurement_topic(std::string_view topic, std::string_view type);

/// What stands on "/drydock/faults". Empty: no such message.
std::optional<std::vector<Fault>> faults_of(std::span<const std::uint8_t> cdr);

/// The way back from CdrPublisher: bytes of a recording to measurements.
class CdrMeasurements {
 public:
  CdrMeasurements();
  CdrMeasurements(CdrMeasurements&&) noexcept;
  CdrMeasurements& operator=(CdrMeasurements&&) noexcept;
  ~CdrMeasurements();

  /// `received_at`: the time that went with the message. Provenance and device are the caller's to
  /// fill in. Empty: not such a message, or no such measurement.
  std::optional<Measurement> read(Kind kind, std::span<const std::uint8_t> cdr, Stamp received_at);

 private:
  struct Decoders;
  std::unique_ptr<Decoders> decoders_;
};

}  // namespace drydock::bus
