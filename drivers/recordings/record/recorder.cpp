#include "drivers/recordings/record/recorder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "drivers/bus/schema.hpp"
#include "drivers/recordings/record/raw_message.hpp"

namespace drydock::record {

Recorder::Recorder(Parts parts, const RecorderOptions& options)
    : tape_(std::move(parts), options.when_behind, options.attachments,
            {{"versions", options.versions}}),
      topics_(tape_, options.devices, options.estimators, options.navigators, options.innovations) {
  for (const auto& link : options.links) {
    const std::string type = link.frames ? can_frame_type : raw_bytes_type;
    links_.push_back(
        {link.uri,
         tape_.add_topic(
             {fmt::format("/raw/{}/{}", link.frames ? "can" : "serial", link.name),
              type,
              bus::ros2_schema(type),
              {{"link", link.uri}, {"devices", fmt::to_string(fmt::join(link.devices, ","))}}})});
  }
  tape_.begin();
}

void Recorder::add_raw(std::string_view link, Stamp at) {
  for (const auto& known : links_)
    if (known.uri == link) return tape_.put(known.topic, link, at, raw_);
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

void Recorder::tick(Stamp now) { tape_.tick(now); }

boost::system::error_code Recorder::finish() { return tape_.finish(); }

TapeStatus Recorder::status() const { return tape_.status(); }

}  // namespace drydock::record
