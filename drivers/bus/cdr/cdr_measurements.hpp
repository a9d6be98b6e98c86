#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/bus/device.hpp"

namespace drydock::bus {

/// The device whose measurements a topic carries.
struct MeasurementTopic {
  std::string device;
  Kind kind = Kind::imu;
};

/// docs/build/bus.md lists the topics. For each device this accepts the one topic that loses no
/// field, without `rt`: "/imu/data", "/dvl/bottom_track". Empty for any other topic.
std::optional<MeasurementTopic> measurement_topic(std::string_view topic, std::string_view type);

/// Decodes a message of "/drydock/faults". Empty if the bytes are no such message.
std::optional<std::vector<Fault>> faults_of(std::span<const std::uint8_t> cdr);

/// The reverse of CdrPublisher: turns the bytes of a recording into measurements.
class CdrMeasurements {
 public:
  CdrMeasurements();
  CdrMeasurements(CdrMeasurements&&) noexcept;
  CdrMeasurements& operator=(CdrMeasurements&&) noexcept;
  ~CdrMeasurements();

  /// `received_at` is the time that was stored with the message. The caller fills in provenance and
  /// device. Empty if the bytes are no such message, or hold no such measurement.
  std::optional<Measurement> read(Kind kind, std::span<const std::uint8_t> cdr, Stamp received_at);

 private:
  struct Decoders;
  std::unique_ptr<Decoders> decoders_;
};

}  // namespace drydock::bus
