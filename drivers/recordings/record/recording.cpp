#include "drivers/recordings/record/recording.hpp"

#include <algorithm>
#include <boost/throw_exception.hpp>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "rig_config/file_trouble.hpp"

namespace drydock::record {

namespace {

constexpr std::string_view raw_prefix = "/raw/";

std::string value_of(const mcap::Map& map, std::string_view key) {
  for (const auto& [name, value] : map)
    if (name == key) return value;
  return {};
}

Stamp stamp_of(const mcap::Message& message) {
  return measurement::stamp_from_ns(
      static_cast<std::int64_t>(std::min(message.log_time, mcap::latest_time)));
}

/// Memory of a record while the file is read: a small compressed file may unpack to any size.
std::size_t kept_size(const mcap::Map& map) {
  std::size_t size = 0;
  for (const auto& [name, value] : map) size += sizeof map.front() + name.size() + value.size();
  return size;
}
std::size_t kept_size(const mcap::Schema& s) {
  return sizeof s + s.name.size() + s.encoding.size() + s.text.size();
}
std::size_t kept_size(const mcap::Channel& c) {
  return sizeof c + c.topic.size() + c.encoding.size() + kept_size(c.metadata);
}
std::size_t kept_size(const mcap::Attachment& a) {
  return sizeof a + a.name.size() + a.media_type.size() + a.data.size();
}
std::size_t kept_size(const mcap::Metadata& m) {
  return sizeof m + m.name.size() + kept_size(m.values);
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
  if (const auto why = rig_config::file_trouble(path); !why.empty())
    return RecordingError{path + ": " + why};
  auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
  return open(std::move(file), path);
}

boost::system::result<Recording, RecordingError> Recording::open(std::unique_ptr<std::istream> file,
                                                                 const std::string& path) {
  Recording recording{mcap::Reader(std::move(file))};
  while (auto record = recording.reader_.next()) {
    if (const auto* message = std::get_if<mcap::Message>(&*record)) {
      recording.first_ = *message;
      recording.begin_ = stamp_of(*message);
      break;
    }
    recording.note(std::move(*record));
    if (!recording.damage_.empty()) return RecordingError{path + ": " + recording.damage_};
  }
  // Other programs that cut or sort a file write a channel when it first speaks, attachments last.
  if (recording.first_)
    for (auto& record : recording.reader_.summary()) recording.note(std::move(record));
  recording.is_open_ = true;
  if (!recording.first_ && recording.channels_.empty() && !recording.damage().empty())
    return RecordingError{path + ": " + recording.damage()};
  return recording;
}

/// Programs repeat schemas and channels in every chunk. A record that replaces another counts once.
template <class Kept>
void Recording::keep(Kept& place, std::type_identity_t<Kept>&& record) {
  const bool was_empty = kept_size(place) == sizeof place;
  kept_bytes_ -= was_empty ? 0 : kept_size(place);
  place = std::move(record);
  kept_bytes_ += kept_size(place);
  if (kept_bytes_ > most_kept) damage_ = "more than 256 MB of schemas, channels and attachments";
}

void Recording::note(mcap::Record&& record) {
  if (auto* schema = std::get_if<mcap::Schema>(&record)) {
    keep(schemas_[schema->id], std::move(*schema));
  } else if (auto* channel = std::get_if<mcap::Channel>(&record)) {
    note_channel(std::move(*channel));
  } else if (auto* attachment_of_file = std::get_if<mcap::Attachment>(&record)) {
    if (attachment(attachment_of_file->name).empty())
      keep(attachments_.emplace_back(), std::move(*attachment_of_file));
  } else if (auto* metadata = std::get_if<mcap::Metadata>(&record)) {
    keep(metadata_.emplace_back(), std::move(*metadata));
  }
}

void Recording::note_channel(mcap::Channel&& channel) {
  const auto& type = schemas_[channel.schema].name;
  const bool is_raw =
      channel.topic.starts_with(raw_prefix) && (type == raw_bytes_type || type == can_frame_type);
  if (is_raw && !link_of_.contains(channel.id)) {
    if (is_open_) {
      late_links_.insert(channel.id);
    } else {
      link_of_[channel.id] = links_.size();
      links_.push_back({value_of(channel.metadata, "link"),
                        channel.topic.substr(channel.topic.rfind('/') + 1), type == can_frame_type,
                        split(value_of(channel.metadata, "devices"))});
    }
  }
  const auto id = channel.id;
  keep(channels_[id], std::move(channel));
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
    if (!link_of_.contains(id) && !late_links_.contains(id)) all.push_back(&channel);
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
  if (late_links_.contains(message.channel)) return {};
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

void Recording::go_on(Event& event) {
  if (auto* known = std::get_if<Understood>(&event)) {
    known->at = Stamp{times_.beside(known->at.time_since_epoch())};
    return;
  }
  auto& raw = std::get<RawEvent>(event);
  const Stamp at{times_.of(links_[raw.link].name, raw.at().time_since_epoch())};
  std::visit([&](auto& content) { content.at = at; }, raw.content);
}

std::string Recording::clock_note() const {
  std::string note = times_.in_words();
  if (beyond_ > 0)
    note += (note.empty() ? "" : "; ") + std::to_string(beyond_) +
            " messages have times after 2116, which are taken as 2116";
  if (!late_links_.empty())
    note += (note.empty() ? "" : "; ") + std::to_string(late_links_.size()) +
            " links begin behind other data of a file without a summary and are not read (drydock "
            "recover writes a summary)";
  return note;
}

std::optional<Event> Recording::next() {
  while (damage_.empty()) {
    std::optional<mcap::Record> record;
    if (first_) {
      record = *first_;
      first_.reset();
    } else {
      record = reader_.next();
    }
    if (!record) return {};
    if (const auto* message = std::get_if<mcap::Message>(&*record)) {
      beyond_ += message->log_time > mcap::latest_time;
      if (auto event = event_of(*message)) {
        go_on(*event);
        return event;
      }
      ++unreadable_;
    } else {
      note(std::move(*record));
    }
  }
  return {};
}

}  // namespace drydock::record
