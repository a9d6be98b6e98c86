#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "drivers/terminal/data_size.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "drivers/text/printable.hpp"
#include "hil/info/recording_info.hpp"
#include "hil/info/utc.hpp"

namespace drydock::info {
namespace {

std::string lines_of(std::string_view head, const std::map<std::string, TopicInfo>& all,
                     record::Stamp begin) {
  if (all.empty()) return "";
  std::string text = fmt::format("{:<44} {:>9} {:>9} {:>10}  {}\n", head, "messages", "Hz", "bytes",
                                 "longest gap");
  for (const auto& [name, topic] : all)
    text +=
        fmt::format("  {:<42} {:>9} {:>9.2f} {:>10}  {:.3f} s at {:.1f} s\n", name, topic.messages,
                    topic.rate_hz(), topic.bytes, measurement::seconds(topic.longest),
                    measurement::seconds(topic.longest_at - begin));
  return text;
}

nlohmann::json json_of(const std::map<std::string, TopicInfo>& all, record::Stamp begin) {
  auto list = nlohmann::json::array();
  for (const auto& [name, topic] : all)
    list.push_back({{"name", name},
                    {"type", topic.type},
                    {"messages", topic.messages},
                    {"bytes", topic.bytes},
                    {"rate_hz", topic.rate_hz()},
                    {"longest_gap_s", measurement::seconds(topic.longest)},
                    {"longest_gap_at_s", measurement::seconds(topic.longest_at - begin)}});
  return list;
}

}  // namespace

std::string to_text(const RecordingInfo& info) {
  std::string text = fmt::format("{}: MCAP recording, {}, {:.1f} s{}\nwritten by {}{}\n", info.file,
                                 terminal::data_size_text(info.size), info.duration_s(),
                                 utc::from(info.begin.time_since_epoch()),
                                 info.written_by.empty() ? "another program" : info.written_by,
                                 info.rig.empty() ? "" : ", rig " + info.rig);
  for (const auto& [link, devices] : info.devices)
    text += fmt::format("link {}: {}\n", link, fmt::join(devices, ", "));
  text += lines_of("links", info.links, info.begin) + lines_of("topics", info.topics, info.begin);
  for (const auto& fault : info.faults)
    text += fmt::format("fault at {:.1f} s: {}\n", measurement::seconds(fault.since - info.begin),
                        fault.text);
  if (info.faults.empty()) text += "no fault was set\n";
  if (!info.attachments.empty())
    text += fmt::format("attached: {}\n", fmt::join(info.attachments, ", "));
  if (!info.holds_something()) text += "it holds no message and no attachment\n";
  if (!info.times.empty()) text += info.times + "\n";
  if (!info.damage.empty()) text += "damaged: " + info.damage + " (drydock recover)\n";
  return text::printable_lines(text);
}

std::string to_json(const RecordingInfo& info) {
  auto faults = nlohmann::json::array();
  for (const auto& fault : info.faults)
    faults.push_back(
        {{"fault", fault.text}, {"since_s", measurement::seconds(fault.since - info.begin)}});
  const nlohmann::json all = {{"file", info.file},
                              {"format", "mcap"},
                              {"size", info.size},
                              {"begin", utc::text(info.begin.time_since_epoch())},
                              {"duration_s", info.duration_s()},
                              {"written_by", info.written_by},
                              {"rig", info.rig},
                              {"devices", info.devices},
                              {"links", json_of(info.links, info.begin)},
                              {"topics", json_of(info.topics, info.begin)},
                              {"faults", faults},
                              {"attachments", info.attachments},
                              {"times", info.times},
                              {"damage", info.damage}};
  return text::json_of_any_text(all) + "\n";
}

}  // namespace drydock::info
