#include "drivers/bus/cdr/cdr_measurements.hpp"

#include <array>

#include "drivers/bus/cdr/cdr.hpp"
#include "drivers/bus/convert/convert.hpp"
#include "drivers/bus/schema.hpp"
#include "drivers/bus/topic.hpp"

namespace drydock::bus {

namespace {

struct CompleteTopic {
  Kind kind;
  std::string_view suffix;
  const dds_topic_descriptor_t* type;
};

template <class Sample, class Message>
CompleteTopic complete(Kind kind) {
  return {kind, route<Sample, Message>.suffix, message_type<Message>.descriptor};
}

const std::array<CompleteTopic, 7>& complete_topics() {
  static const std::array<CompleteTopic, 7> topics{
      complete<BottomVelocity, BottomTrackMessage>(Kind::dvl),
      complete<WaterSpeed, WaterSpeedMessage>(Kind::emlog),
      complete<GnssFix, GnssFixMessage>(Kind::gnss),
      complete<ImuSample, ImuMessage>(Kind::imu),
      complete<DepthSample, DepthMessage>(Kind::depth),
      complete<ActuatorState, ActuatorStateMessage>(Kind::actuator),
      complete<AttitudeSample, AttitudeMessage>(Kind::attitude)};
  return topics;
}

}  // namespace

std::optional<MeasurementTopic> measurement_topic(std::string_view topic, std::string_view type) {
  const std::string full = "rt" + std::string(topic);
  for (const auto& known : complete_topics()) {
    const std::string ending = "/" + std::string(known.suffix);
    if (!full.ends_with(ending) || type != ros2_type(known.type->m_typename)) continue;
    const std::string device = full.substr(3, full.size() - 3 - ending.size());
    // Attitude estimates have the same message type as the data of an IMU, but are no measurements.
    if (full != topic_name(device, known.suffix) ||
        full == estimate_topic(std::string(known.suffix)))
      continue;
    return MeasurementTopic{device, known.kind};
  }
  return std::nullopt;
}

std::optional<std::vector<Fault>> faults_of(std::span<const std::uint8_t> cdr) {
  CdrDecoder<FaultsMessage> decoder;
  const auto* message = decoder.decode(cdr);
  return message != nullptr ? std::optional(read(*message)) : std::nullopt;
}

struct CdrMeasurements::Decoders {
  CdrDecoder<BottomTrackMessage> dvl;
  CdrDecoder<WaterSpeedMessage> emlog;
  CdrDecoder<GnssFixMessage> gnss;
  CdrDecoder<ImuMessage> imu;
  CdrDecoder<DepthMessage> depth;
  CdrDecoder<ActuatorStateMessage> actuator;
  CdrDecoder<AttitudeMessage> attitude;
};

namespace {

template <class Sample, class Message>
std::optional<Measurement> sample_of(CdrDecoder<Message>& decoder,
                                     std::span<const std::uint8_t> cdr, Stamp received_at) {
  const Message* message = decoder.decode(cdr);
  Sample sample;
  if (message == nullptr || !read(sample, *message)) return std::nullopt;
  sample.origin.received_at = received_at;
  return sample;
}

}  // namespace

CdrMeasurements::CdrMeasurements() : decoders_(std::make_unique<Decoders>()) {}
CdrMeasurements::CdrMeasurements(CdrMeasurements&&) noexcept = default;
CdrMeasurements& CdrMeasurements::operator=(CdrMeasurements&&) noexcept = default;
CdrMeasurements::~CdrMeasurements() = default;

std::optional<Measurement> CdrMeasurements::read(Kind kind, std::span<const std::uint8_t> cdr,
                                                 Stamp at) {
  switch (kind) {
    case Kind::dvl: return sample_of<BottomVelocity>(decoders_->dvl, cdr, at);
    case Kind::emlog: return sample_of<WaterSpeed>(decoders_->emlog, cdr, at);
    case Kind::gnss: return sample_of<GnssFix>(decoders_->gnss, cdr, at);
    case Kind::imu: return sample_of<ImuSample>(decoders_->imu, cdr, at);
    case Kind::depth: return sample_of<DepthSample>(decoders_->depth, cdr, at);
    case Kind::actuator: return sample_of<ActuatorState>(decoders_->actuator, cdr, at);
    case Kind::attitude: return sample_of<AttitudeSample>(decoders_->attitude, cdr, at);
  }
  return std::nullopt;
}

}  // namespace drydock::bus
