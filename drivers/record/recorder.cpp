#include "drivers/record/recorder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "drivers/bus/outlets.hpp"
#include "drivers/record/raw_message.hpp"
#include "drivers/record/track.hpp"

namespace drydock::record {

struct Recorder::Tracks {
  Tracks(Tape& tape, const RecorderOptions& options)
      : diagnostics(tape, encoder, std::string(bus::diagnostics_topic), "") {
    const auto open = [&]<class Message>(const std::string& topic, const std::string& frame) {
      return Track<Message>(tape, encoder, topic, frame);
    };
    for (const auto& device : options.devices) devices.emplace_back(device, open);
    for (const auto& name : options.estimators)
      estimates.emplace_back(tape, encoder, bus::estimate_topic(name), "base_link");
  }

  bus::CdrEncoder encoder;
  std::vector<bus::DeviceOutlets<Track>> devices;
  std::vector<Track<bus::ImuMessage>> estimates;
  Track<bus::DiagnosticsMessage> diagnostics;
};

Recorder::Recorder(mcap::Sink sink, const RecorderOptions& options)
    : tape_(std::move(sink), options.when_behind, options.attachments,
            {{"versions", options.versions}}) {
  for (const auto& link : options.links) {
    const std::string topic = fmt::format("/raw/{}/{}", link.frames ? "can" : "serial", link.name);
    links_.push_back(
        {link.uri, tape_.add_channel(topic, link.frames ? can_frame_type : raw_bytes_type,
                                     {{"link", link.uri},
                                      {"devices", fmt::to_string(fmt::join(link.devices, ","))}})});
  }
  tracks_ = std::make_unique<Tracks>(tape_, options);
  tape_.begin();
}

Recorder::~Recorder() = default;

void Recorder::add_raw(std::string_view link, Stamp at) {
  for (const auto& known : links_)
    if (known.uri == link) return tape_.add(known.channel, at, raw_);
}

void Recorder::on_bytes(std::string_view link, shell::Direction direction, wire::Bytes bytes,
                        Stamp at) {
  encode(raw_, RawBytes{at, direction, bytes});
  add_raw(link, at);
}

void Recorder::on_frame(std::string_view link, shell::Direction direction,
                        const wire::CanFrame& frame, Stamp at) {
  encode(raw_, RawFrame{at, direction, frame});
  add_raw(link, at);
}

void Recorder::note(const measurement::Measurement& measurement) {
  const auto device = measurement::origin_of(measurement).device;
  if (device < tracks_->devices.size()) tracks_->devices[device].publish(measurement);
}

void Recorder::note(const bus::Attitude& attitude, std::size_t estimator) {
  if (estimator >= tracks_->estimates.size()) return;
  auto& track = tracks_->estimates[estimator];
  bus::fill(track.message(), attitude);
  track.write(attitude.valid_at);
}

void Recorder::note(std::span<const bus::DeviceStatus> health, Stamp now) {
  bus::fill(tracks_->diagnostics.message(), health, now);
  tracks_->diagnostics.write(now);
}

void Recorder::tick(Stamp now) { tape_.tick(now); }

boost::system::error_code Recorder::finish() { return tape_.finish(); }

TapeStatus Recorder::status() const { return tape_.status(); }

}  // namespace drydock::record
