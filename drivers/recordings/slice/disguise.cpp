#include "drivers/recordings/slice/disguise.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/measurement/units.hpp"
#include "drivers/recordings/record/layouts.hpp"
#include "drivers/recordings/slice/move_understood.hpp"
#include "drivers/wire/protocols.hpp"
#include "rig_config/toml/rewrite.hpp"

namespace drydock::slice {

namespace {

/// Rounds degrees to a tenth of a millimetre.
double written(double deg) {
  constexpr double steps = 1e9;
  return std::round(deg * steps) / steps;
}

}  // namespace

Disguise::Disguise(const Options& options, const std::vector<record::RecordedLink>& links,
                   const std::optional<rig_config::Rig>& rig)
    : options_(options) {
  if (options.move_to) place_.emplace(*options.move_to);
  if (place_ && options.first) place_->start_at(*options.first);
  for (const auto& link : links) lines_.push_back(place_ ? line_of(link, rig) : Line::passes);
}

Disguise::Line Disguise::line_of(const record::RecordedLink& link,
                                 const std::optional<rig_config::Rig>& rig) const {
  if (!rig) return Line::unknown;
  Line line = link.frames ? Line::bus : Line::unknown;
  for (const auto& device : rig->devices) {
    const wire::Protocol* known = rig_config::protocol_of(device);
    if (!known || std::ranges::find(link.devices, device.name) == link.devices.end()) continue;
    switch (known->place) {
      case wire::Place::under_any_identifier: return Line::unknown;
      case wire::Place::of_bus: break;
      case wire::Place::no:
        if (!link.frames) line = Line::passes;
        break;
      case wire::Place::yes:
      case wire::Place::of_receiver:
        if (!link.frames) line = Line::receiver;
        break;
    }
  }
  return line;
}

std::optional<measurement::Geodetic> Disguise::first_position() const {
  return place_ ? place_->start() : std::nullopt;
}

void Disguise::note(const mcap::Channel& channel, const mcap::Schema& schema,
                    std::optional<std::size_t> link) {
  if (tracks_.contains(channel.id)) return;
  Track track;
  track.type = schema.name;
  track.frames = schema.name == record::can_frame_type;
  if (link) {
    track.line = lines_.at(*link);
    if (place_) {
      track.receiver = std::make_unique<ReceiverLine>(*place_, dropped_);
      track.bus = std::make_unique<BusPlace>(*place_, dropped_);
    }
  } else {
    if (auto layout = record::layout_of(channel, schema)) track.layout = std::move(*layout);
  }
  tracks_[channel.id] = std::move(track);
}

void Disguise::apply(mcap::Message message, const Emit& emit) {
  auto& track = tracks_[message.channel];
  const auto shift = static_cast<std::uint64_t>(options_.shift.count());
  message.log_time += shift;
  message.publish_time += shift;
  if (track.line ? apply_raw(track, message, emit) : apply_understood(track, message))
    emit(message);
}

void Disguise::finish(const Emit& emit) {
  for (auto& [channel, track] : tracks_)
    if (track.receiver) emit_moved(track, track.receiver->finish(), emit);
}

bool Disguise::apply_raw(Track& track, mcap::Message& message, const Emit& emit) {
  if (*track.line == Line::unknown) {
    ++dropped_[track.frames ? "frames of an unknown bus" : "reads of an unknown line"];
    return false;
  }
  if (track.frames) {
    auto raw = record::decode_frame(message.data);
    if (!raw || (*track.line == Line::bus && !track.bus->move(raw->frame))) return false;
    raw->at += options_.shift;
    record::encode(data_, *raw);
  } else {
    auto raw = record::decode_bytes(message.data);
    if (!raw) return false;
    raw->at += options_.shift;
    if (*track.line == Line::receiver) {
      if (raw->direction == record::Direction::sent) {  // a host may send a receiver its position
        ++dropped_["writes to a receiver"];
        return false;
      }
      track.last = message;
      track.last_at = raw->at;
      emit_moved(track, track.receiver->move(raw->data, raw->at), emit);
      return false;
    }
    record::encode(data_, *raw);
  }
  message.data = data_;
  return true;
}

void Disguise::emit_moved(const Track& track, const std::vector<ReceiverLine::Moved>& moved,
                          const Emit& emit) {
  for (const auto& read : moved) {
    mcap::Message message = track.last;
    const auto waited = static_cast<std::uint64_t>((track.last_at - read.at).count());
    message.log_time -= waited;
    message.publish_time -= waited;
    record::encode(data_, record::RawBytes{read.at, record::Direction::received, read.bytes});
    message.data = data_;
    emit(message);
  }
}

bool Disguise::apply_understood(const Track& track, mcap::Message& message) {
  const bool read = track.layout && record::misfit(*track.layout, message.data).empty();
  if (place_ && (!read || !may_be_kept(track.type))) {
    ++dropped_[track.type];
    return false;
  }
  if (!read) return true;
  data_.assign(message.data.begin(), message.data.end());
  if (options_.shift.count() != 0) shift_stamps(*track.layout, data_, options_.shift);
  if (place_ && move_position(track.type, *track.layout, data_, *place_)) ++moved_;
  message.data = data_;
  return true;
}

bool Disguise::apply(mcap::Attachment& attachment) {
  const auto shift = static_cast<std::uint64_t>(options_.shift.count());
  attachment.log_time += shift;
  attachment.create_time += shift;
  if (!place_ && shift == 0) return true;
  rig_config::Rewriting rewriting;
  rewriting.without_dates = shift != 0;
  rewriting.number = [this](std::string_view key, double value) {
    if (!place_) return value;
    if (key == "latitude_deg")
      return written(place_->latitude(value * units::degree) / units::degree);
    if (key == "longitude_deg")
      return written(place_->longitude(value * units::degree) / units::degree);
    return value;
  };
  const auto text = attachment.name.ends_with(".toml")
                        ? rig_config::rewrite(attachment.data, rewriting)
                        : std::nullopt;
  if (!text) {
    ++dropped_["attachment " + attachment.name];
    return false;
  }
  attachment.data = *text;
  return true;
}

std::uint64_t Disguise::moved() const {
  std::uint64_t all = moved_;
  for (const auto& [id, track] : tracks_) {
    if (track.receiver) all += track.receiver->moved();
    if (track.bus) all += track.bus->moved();
  }
  return all;
}

}  // namespace drydock::slice
