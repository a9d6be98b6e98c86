#include "drivers/bus/subscriber.hpp"

#include <algorithm>

#include "drivers/bus/reader.hpp"

namespace drydock::bus {
namespace {

using Sources = std::vector<std::unique_ptr<Source>>;

class AttitudeSource final : public ReaderSource<ImuMessage> {
 public:
  AttitudeSource(const Participant& participant, const std::string& estimator, std::size_t index,
                 Doorbell& doorbell)
      : ReaderSource(participant, estimate_topic(estimator), doorbell), index_(index) {}

  std::size_t take(Receiver& receiver) override {
    std::size_t count = 0;
    reader_.drain([&](const ImuMessage& message, const dds_sample_info_t&) {
      Attitude attitude;
      if (!read(attitude, message)) {
        ++unusable_;
        return;
      }
      receiver.receive(attitude, index_);
      ++count;
    });
    return count;
  }

 private:
  std::size_t index_;
};

class DiagnosticsSource final : public ReaderSource<DiagnosticsMessage> {
 public:
  DiagnosticsSource(const Participant& participant, Doorbell& doorbell)
      : ReaderSource(participant, std::string(diagnostics_topic), doorbell) {}

  std::size_t take(Receiver& receiver) override {
    std::size_t count = 0;
    reader_.drain([&](const DiagnosticsMessage& message, const dds_sample_info_t&) {
      for (std::uint32_t i = 0; i < message.status._length; ++i) {
        receiver.receive(read(message.status._buffer[i]));
        ++count;
      }
    });
    return count;
  }
};

/// Adds the readers of one device to a subscriber.
struct DeviceSources {
  const Participant& participant;
  const Device& device;
  std::uint16_t index;
  bool own_only;
  Doorbell& doorbell;
  Sources& sources;

  template <class Sample, class Message>
  void add() {
    sources.push_back(std::make_unique<SampleSource<Sample, Message>>(participant, device, index,
                                                                      own_only, doorbell));
  }

  template <class Sample, class Complete, class Standard>
  void add_as_asked() {
    device.form == Form::complete ? add<Sample, Complete>() : add<Sample, Standard>();
  }

  void add_all() {
    switch (device.kind) {
      case Kind::dvl: return add_as_asked<BottomVelocity, BottomTrackMessage, DvlMessage>();
      case Kind::emlog: return add_as_asked<WaterSpeed, WaterSpeedMessage, TwistMessage>();
      case Kind::gnss:
        add_as_asked<GnssFix, GnssFixMessage, NavSatFixMessage>();
        return add<GnssSatellites, GnssSatellitesMessage>();
      case Kind::imu: return add<ImuSample, ImuMessage>();
      case Kind::depth: return add_as_asked<DepthSample, DepthMessage, FluidPressureMessage>();
      case Kind::actuator: return add<ActuatorState, ActuatorStateMessage>();
      case Kind::attitude: return add<AttitudeSample, AttitudeMessage>();
    }
  }
};

std::optional<Provenance> declared_in(std::string_view user_data) {
  for (const auto provenance : {Provenance::real, Provenance::emulated, Provenance::replayed}) {
    const std::string pair = "provenance=" + std::string(to_string(provenance)) + ";";
    if (user_data.find(pair) != std::string_view::npos) return provenance;
  }
  return std::nullopt;
}

using WriterData =
    std::unique_ptr<dds_builtintopic_endpoint_t, decltype(&dds_builtintopic_free_endpoint)>;

std::string user_data_of(const WriterData& writer) {
  void* bytes = nullptr;
  std::size_t size = 0;
  if (!writer || !dds_qget_userdata(writer->qos, &bytes, &size)) return {};
  std::string text(static_cast<const char*>(bytes), size);
  dds_free(bytes);
  return text;
}

bool is_of(const WriterData& writer, dds_entity_t participant) {
  dds_guid_t own{};
  return writer && dds_get_guid(participant, &own) == DDS_RETCODE_OK &&
         std::ranges::equal(writer->participant_key.v, own.v);
}

}  // namespace

WriterFacts KnownWriters::of(dds_entity_t reader, dds_instance_handle_t writer) {
  const auto known = std::ranges::find(known_, writer, &WriterFacts::handle);
  if (known != known_.end()) return *known;
  const WriterData data(dds_get_matched_publication_data(reader, writer),
                        &dds_builtintopic_free_endpoint);
  if (!data) return {writer, undeclared_, true};  // it has gone already
  if (known_.size() == most_known) known_.erase(known_.begin());
  known_.push_back({writer, declared_in(user_data_of(data)).value_or(undeclared_),
                    is_of(data, dds_get_participant(reader))});
  return known_.back();
}

struct Subscriber::Readers {
  Doorbell doorbell;
  Sources sources;  ///< declared after the doorbell: their callbacks must end before it closes
};

Subscriber::Subscriber(const Participant& participant, const std::vector<Device>& devices,
                       const SubscriberOptions& options)
    : readers_(new Readers) {
  auto& [doorbell, sources] = *readers_;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    DeviceSources{participant,      devices[i], static_cast<std::uint16_t>(i),
                  options.own_only, doorbell,   sources}
        .add_all();
  }
  for (std::size_t i = 0; i < options.estimators.size(); ++i) {
    sources.push_back(
        std::make_unique<AttitudeSource>(participant, options.estimators[i], i, doorbell));
  }
  if (options.diagnostics) {
    sources.push_back(std::make_unique<DiagnosticsSource>(participant, doorbell));
  }
}

Subscriber::Subscriber(Subscriber&&) noexcept = default;
Subscriber& Subscriber::operator=(Subscriber&&) noexcept = default;
Subscriber::~Subscriber() = default;

int Subscriber::fd() const { return readers_->doorbell.fd(); }

std::size_t Subscriber::take(Receiver& receiver) {
  readers_->doorbell.silence();
  std::size_t count = 0;
  for (const auto& source : readers_->sources) count += source->take(receiver);
  return count;
}

std::size_t Subscriber::matched_writers() const {
  std::size_t count = 0;
  for (const auto& source : readers_->sources) count += source->matched();
  return count;
}

std::uint64_t Subscriber::foreign() const {
  std::uint64_t count = 0;
  for (const auto& source : readers_->sources) count += source->foreign();
  return count;
}

std::uint64_t Subscriber::unusable() const {
  std::uint64_t count = 0;
  for (const auto& source : readers_->sources) count += source->unusable();
  return count;
}

}  // namespace drydock::bus
