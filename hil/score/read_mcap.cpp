#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "drivers/recordings/record/recording.hpp"
#include "hil/score/estimate_topic.hpp"
#include "hil/score/read_estimates.hpp"
#include "hil/score/topic_choice.hpp"

namespace drydock::score {
namespace {

const MessageType* type_named(const std::string& name) {
  const auto types = message_types();
  const auto found = std::ranges::find(types, name, &MessageType::name);
  return found == types.end() ? nullptr : &*found;
}

EstimateTopics topics_in(record::Recording& recording) {
  EstimateTopics topics;
  while (const auto event = recording.next()) {
    const auto* message = std::get_if<record::Understood>(&*event);
    if (message == nullptr) continue;
    if (const auto* type = type_named(message->schema->name))
      topics[message->channel->topic] = type;
  }
  return topics;
}

std::set<std::string> devices_of(const record::Recording& recording) {
  std::set<std::string> devices;
  for (const auto& link : recording.links())
    devices.insert(link.devices.begin(), link.devices.end());
  return devices;
}

/// Of the chosen topics, which say a thing in their order.
boost::system::result<Estimates, Problem> estimates_of(const std::string& path,
                                                       const EstimateTopics& known,
                                                       const TopicChoice& choice,
                                                       const frame::Position& origin) {
  auto recording = record::Recording::open(path);
  if (!recording) return Problem{recording.error().line};
  std::map<std::string, EstimateTopic> topics;
  for (const auto& name : choice.topics) topics.try_emplace(name, *known.at(name), origin);
  record::Layouts layouts;
  while (const auto event = recording->next()) {
    const auto* message = std::get_if<record::Understood>(&*event);
    if (message == nullptr) continue;
    const auto topic = topics.find(message->channel->topic);
    if (topic != topics.end()) topic->second.read(layouts.of(*message), message->cdr);
  }
  Estimates all = topics.at(choice.topics.front()).result();
  for (std::size_t i = 1; i < choice.topics.size(); ++i)
    add_to(all.track, topics.at(choice.topics[i]).result().track);
  if (!choice.note.empty()) all.notes.push_back(choice.note);
  if (!recording->damage().empty()) all.notes.push_back(recording->damage());
  return all;
}

}  // namespace

boost::system::result<Estimates, Problem> read_mcap(const std::string& path,
                                                    const std::string& topic,
                                                    const frame::Position& origin) {
  auto recording = record::Recording::open(path);
  if (!recording) return Problem{recording.error().line};
  const auto devices = devices_of(*recording);
  const auto topics = topics_in(*recording);
  const auto choice = choose_topics(topics, devices, topic);
  if (!choice) return Problem{fmt::format("{}: {}", path, choice.error().line)};
  return estimates_of(path, topics, *choice, origin);
}

}  // namespace drydock::score
