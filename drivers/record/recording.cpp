#include "drivers/record/recording.hpp"

#include <algorithm>
#include <boost/throw_exception.hpp>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace drydock::record {

namespace {

constexpr std::string_view raw_prefix = "/raw/";

std::string value_of(const mcap::Map& map, std::string_view key) {
  for (const auto& [name, value] : map)
    if (name == key) return value;
  return {};
}

Stamp stamp_of(const mcap::Message& message) {
  return measurement::stamp_from_ns(static_cast<std::int64_t>(message.log_time));
}

std::vector<std::string> split(const std::string& names) {
  std::vector<std::string> all;
  std::istringstream in(names);
  for (std::string name; std::getline(in, name, ',');) all.push_back(name);
  return all;
}

}  // namespace

void throw_exception_from_error(const RecordingError& error, const boost::source_location& where) {
  boost::throw_exception(std::runtime_error(error.line), where);
}

boost::system::result<Recording, RecordingError> Recording::open(const std::string& path) {
  auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*file) return RecordingError{path + ": " + std::strerror(errno)};
  Recording recording{mcap::Reader(std::move(file))};
  while (auto record = recording.reader_.next()) {
    if (const auto* message = std::get_if<mcap::Message>(&*record)) {
      recording.first_ = *message;
      recording.begin_ = stamp_of(*message);
      break;
    }
    recording.note(std::move(*record));
  }
  if (!recording.first_ && recording.channels_.empty() && !recording.damage().empty())
    return RecordingError{path + ": " + recording.damage()};
  return recording;
}

void Recording::note(mcap::Record&& record) {
  if (auto* schema = std::get_if<mcap::Schema>(&record)) {
    schemas_[schema->id] = std::move(*schema);
  } else if (auto* channel = std::get_if<mcap::Channel>(&record)) {
    note_channel(std::move(*channel));
  } else if (auto* attachment = std::get_if<mcap::Attachment>(&record)) {
    attachments_.push_back(std::move(*attachment));
  } else if (auto* metadata = std::get_if<mcap::Metadata>(&record)) {
    metadata_.push_back(std::move(*metadata));
  }
}

void Recording::note_channel(mcap::Channel&& channel) {
  const auto& type = schemas_[channel.schema].name;
  if (channel.topic.starts_with(raw_prefix) && (type == raw_bytes_type || type == can_frame_type) &&
      !link_of_.contains(channel.id)) {
    link_of_[channel.id] = links_.size();
    links_.push_back({value_of(channel.metadata, "link"),
                      channel.topic.substr(channel.topic.rfind('/') + 1), type == can_frame_type,
                      split(value_of(channel.metadata, "devices"))});
  }
  const auto id = channel.id;
  channels_[id] = std::move(channel);
}

std::string Recording::attachment(std::string_view name) const {
  for (const auto& attachment : attachments_)
    if (attachment.name == name) return attachment.data;
  return {};
}

std::optional<std::size_t> Recording::link_of(std::uint16_t channel) const {
  const auto found = link_of_.find(channel);
  return found == link_of_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<const mcap::Channel*> Recording::understood() const {
  std::vector<const mcap::Channel*> all;
  for (const auto& [id, channel] : channels_)
    if (!link_of_.contains(id)) all.push_back(&channel);
  return all;
}

double Recording::done() const {
  return static_cast<double>(reader_.position()) /
         static_cast<double>(std::max<std::uint64_t>(reader_.size(), 1));
}

std::optional<Event> Recording::event_of(const mcap::Message& message) {
  const auto channel = channels_.find(message.channel);
  if (channel == channels_.end()) return {};
  const auto link = link_of_.find(message.channel);
  if (link == link_of_.end()) {
    return Understood{&channel->second, &schemas_[channel->second.schema], stamp_of(message),
                      message.data};
  }
  if (links_[link->second].frames) {
    if (const auto frame = decode_frame(message.data)) return RawEvent{link->second, *frame};
  } else if (const auto bytes = decode_bytes(message.data)) {
    return RawEvent{link->second, *bytes};
  }
  return {};
}

std::optional<Event> Recording::next() {
  for (;;) {
    std::optional<mcap::Record> record;
    if (first_) {
      record = *first_;
      first_.reset();
    } else {
      record = reader_.next();
    }
    if (!record) return {};
    if (const auto* message = std::get_if<mcap::Message>(&*record)) {
      if (auto event = event_of(*message)) return event;
      ++unreadable_;
    } else {
      note(std::move(*record));
    }
  }
}

}  // namespace drydock::record
