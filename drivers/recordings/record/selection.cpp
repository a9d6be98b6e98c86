#include "drivers/recordings/record/selection.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace drydock::record {

namespace {

bool names(const std::vector<std::string>& only, const std::string& name) {
  return only.empty() || std::ranges::find(only, name) != only.end();
}

/// "/imu/data" belongs to imu, "/estimate/leveling" to leveling, "/diagnostics" to diagnostics.
std::string owner_of(const std::string& topic) {
  constexpr std::string_view estimate = "/estimate/";
  const std::size_t begin = topic.starts_with(estimate) ? estimate.size() : 1;
  return begin < topic.size() ? topic.substr(begin, topic.find('/', begin) - begin) : topic;
}

}  // namespace

bool Selection::takes(const RecordedLink& link) const {
  return names(only, link.name) ||
         std::ranges::any_of(link.devices, [&](const auto& device) { return names(only, device); });
}

bool Selection::takes(const mcap::Channel& channel) const {
  return names(only, owner_of(channel.topic));
}

bool Selection::holds(Stamp at, Stamp begin) const {
  return (!from || at - begin >= *from) && (!to || at - begin < *to);
}

std::string misfit(const Selection& selection, const Recording& recording) {
  std::set<std::string> known;
  for (const auto& link : recording.links()) {
    known.insert(link.name);
    known.insert(link.devices.begin(), link.devices.end());
  }
  for (const auto* channel : recording.understood()) known.insert(owner_of(channel->topic));
  for (const auto& name : selection.only)
    if (!known.contains(name))
      return fmt::format("--only: there is no \"{}\" in the recording; it has {}", name,
                         fmt::join(known, ", "));
  return {};
}

}  // namespace drydock::record
