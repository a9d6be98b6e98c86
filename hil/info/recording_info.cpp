#include "hil/info/recording_info.hpp"

#include <algorithm>
#include <filesystem>

#include "drivers/bus/cdr/cdr_measurements.hpp"

namespace drydock::info {
namespace {

using record::Stamp;

void note_faults(const record::Understood& message, RecordingInfo& info) {
  if (message.channel->topic != "/drydock/faults") return;
  for (const auto& fault : bus::faults_of(message.cdr).value_or(std::vector<bus::Fault>{})) {
    const bool known = std::ranges::any_of(info.faults, [&](const FaultInfo& one) {
      return one.text == fault.text && one.since == fault.since;
    });
    if (!known) info.faults.push_back({fault.text, fault.since});
  }
}

void note(const record::Understood& message, RecordingInfo& info) {
  auto& topic = info.topics[message.channel->topic];
  topic.type = message.schema->name;
  topic.add(message.at, message.cdr.size());
  note_faults(message, info);
}

void note(const record::RawEvent& event, const record::Recording& recording, RecordingInfo& info) {
  const auto& link = recording.links()[event.link];
  auto& topic = info.links[link.uri];
  topic.type = link.frames ? "frames" : "bytes";
  const auto* bytes = std::get_if<record::RawBytes>(&event.content);
  topic.add(event.at(), bytes ? bytes->data.size()
                              : std::get<record::RawFrame>(event.content).frame.payload().size());
}

Stamp time_of(const record::Event& event) {
  if (const auto* raw = std::get_if<record::RawEvent>(&event)) return raw->at();
  return std::get<record::Understood>(event).at;
}

void note_head(const record::Recording& recording, RecordingInfo& info) {
  for (const auto& link : recording.links()) info.devices[link.uri] = link.devices;
  for (const auto& attachment : recording.attachments())
    info.attachments.push_back(attachment.name);
  for (const auto& metadata : recording.metadata())
    for (const auto& [key, value] : metadata.values) {
      if (key == "drydock") info.written_by = "drydock " + value;
      if (key == "rig") info.rig = value;
    }
}

}  // namespace

void TopicInfo::add(Stamp at, std::size_t size) {
  if (messages == 0) first = last = at;
  if (at - last > longest) {
    longest = at - last;
    longest_at = last;
  }
  last = std::max(last, at);
  ++messages;
  bytes += size;
}

double TopicInfo::rate_hz() const {
  const double covered_s = measurement::seconds(last - first);
  return messages > 1 && covered_s > 0 ? static_cast<double>(messages - 1) / covered_s : 0;
}

double RecordingInfo::duration_s() const { return measurement::seconds(end - begin); }

RecordingInfo info_of(record::Recording& recording, const std::string& file) {
  RecordingInfo info;
  info.file = file;
  std::error_code unknown;
  info.size = std::filesystem::file_size(file, unknown);
  info.begin = info.end = recording.begin().value_or(Stamp{});
  while (const auto event = recording.next()) {
    info.begin = std::min(info.begin, time_of(*event));
    info.end = std::max(info.end, time_of(*event));
    if (const auto* raw = std::get_if<record::RawEvent>(&*event))
      note(*raw, recording, info);
    else
      note(std::get<record::Understood>(*event), info);
  }
  note_head(recording, info);
  info.times = recording.clock_note();
  info.damage = recording.damage();
  return info;
}

}  // namespace drydock::info
