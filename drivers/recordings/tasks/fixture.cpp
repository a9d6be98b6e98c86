#include "drivers/recordings/tasks/fixture.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>

#include "drivers/recordings/record/player.hpp"
#include "drivers/text/json_lines.hpp"
#include "drivers/text/measurement_fields.hpp"

namespace drydock::recordings {

namespace {

std::string hex_of(wire::Bytes bytes) { return fmt::format("{:02X}", fmt::join(bytes, "")); }

/// The form of candump: a 29-bit identifier has eight digits.
std::string text_of(const wire::CanFrame& frame) {
  return fmt::format("{:0{}X}#{}", frame.id, frame.extended ? 8 : 3, hex_of(frame.payload()));
}

/// Writes the lines of one replay.
class Account final : public device::Listener, public shell::RawListener {
 public:
  Account(const record::Recording& recording, const rig_config::Rig& rig, std::FILE* out)
      : recording_(recording),
        rig_(rig),
        begin_(recording.begin().value_or(measurement::Stamp{})),
        lines_(out),
        heard_(recording.links().size()) {}

  void on_measurement(const measurement::Measurement& measurement) override {
    ++measurements_;
    std::visit([&](const auto& m) { write(m); }, measurement);
  }
  void on_state(const device::Device& device, const device::Transition& change) override {
    lines_.line([&](text::JsonWriter& json) {
      json.field("device", std::string_view(device.name()));
      json.field("state", to_string(change.to));
      json.field("at_s", since_begin(change.at));
      json.field("why", change.why.view());
    });
  }
  void on_bytes(std::string_view link, shell::Direction, wire::Bytes bytes,
                measurement::Stamp at) override {
    write_sent(link, hex_of(bytes), at);
  }
  void on_frame(std::string_view link, shell::Direction, const wire::CanFrame& frame,
                measurement::Stamp at) override {
    write_sent(link, text_of(frame), at);
  }

  void hear(const record::RawEvent& event) {
    if (event.direction() != shell::Direction::received) return;
    Heard& heard = heard_[event.link];
    ++heard.events;
    if (const auto* read = std::get_if<record::RawBytes>(&event.content)) {
      heard.crc.process_bytes(read->data.data(), read->data.size());
    } else {
      const std::string text = text_of(std::get<record::RawFrame>(event.content).frame);
      heard.crc.process_bytes(text.data(), text.size());
    }
  }
  void write_totals(const record::Player& player) {
    for (const auto& actor : player.devices()) write_totals(actor->device(), player.now());
    for (std::size_t i = 0; i < heard_.size(); ++i) {
      lines_.line([&](text::JsonWriter& json) {
        json.field("link", std::string_view(recording_.links()[i].uri));
        json.field("received", heard_[i].events);
        json.field("crc32", std::string_view(fmt::format("{:08X}", heard_[i].crc.checksum())));
      });
    }
  }

  bool flush() { return lines_.flush(); }
  std::uint64_t measurements() const { return measurements_; }

 private:
  struct Heard {
    std::uint64_t events = 0;
    boost::crc_32_type crc;
  };

  double since_begin(measurement::Stamp at) const { return measurement::seconds(at - begin_); }

  void write(const auto& m) {
    lines_.line([&](text::JsonWriter& json) {
      json.field("device", std::string_view(rig_.devices[m.origin.device].name));
      json.field("type", type_of(m));
      json.field("valid_at_s", since_begin(m.origin.valid_at));
      json.field("received_at_s", since_begin(m.origin.received_at));
      json.fields(m);
    });
  }
  void write_sent(std::string_view link, const std::string& what, measurement::Stamp at) {
    lines_.line([&](text::JsonWriter& json) {
      json.field("link", link);
      json.field("sent", std::string_view(what));
      json.field("at_s", since_begin(at));
    });
  }
  void write_totals(const device::Device& device, measurement::Stamp now) {
    const auto health = device.health(now);
    lines_.line([&](text::JsonWriter& json) {
      json.field("device", std::string_view(device.name()));
      json.field("measurements", health.messages);
      json.field("frames", health.stream.frames);
      json.field("bytes_good", health.stream.bytes_good);
      json.field("bytes_skipped", health.stream.bytes_skipped);
      json.field("bad_checksums", health.stream.bad_checksums);
      json.field("last_error", health.last_error.view());
    });
  }

  const record::Recording& recording_;
  const rig_config::Rig& rig_;
  measurement::Stamp begin_;
  text::JsonLines lines_;
  std::vector<Heard> heard_;  ///< one for each link of the recording
  std::uint64_t measurements_ = 0;
};

}  // namespace

boost::system::result<std::uint64_t, record::RecordingError> write_reference(
    const std::string& path, std::FILE* out) {
  auto recording = record::Recording::open(path);
  if (!recording) return recording.error();
  const auto rig = record::rig_of(*recording);
  if (!rig) return record::RecordingError{path + ": " + rig.error().line};
  Account account(*recording, *rig, out);
  auto player = record::Player::make(*recording, *rig, {}, account, &account);
  if (!player) return record::RecordingError{path + ": " + player.error().line};
  record::play(*recording, {}, **player, [&](const auto& event) { account.hear(event); });
  if (!recording->damage().empty())
    return record::RecordingError{path + ": " + recording->damage()};
  account.write_totals(**player);
  if (!account.flush()) return record::RecordingError{"cannot write the reference"};
  return account.measurements();
}

}  // namespace drydock::recordings
