#include <fmt/format.h>

#include <map>

#include "drivers/recordings/record/message_layout.hpp"
#include "drivers/recordings/record/recording.hpp"
#include "hil/replay/reference/references.hpp"
#include "hil/score/axes.hpp"
#include "hil/score/read_estimates.hpp"

namespace drydock::score {
namespace {

using Values = std::map<std::string, double>;

Values values_in(const record::MessageNode& layout, mcap::Bytes cdr) {
  Values all;
  for (const auto& [name, value] : replay::values_of(layout, cdr))
    if (value.is_number()) all[name] = value.template get<double>();
  return all;
}

std::optional<Pose> odometry_pose(const Values& v) {
  const auto at = [&v](const char* name) {
    const auto found = v.find(name);
    return found == v.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
  };
  const Eigen::Vector3d position{at("pose.pose.position.x"), at("pose.pose.position.y"),
                                 at("pose.pose.position.z")};
  const Eigen::Quaterniond q(at("pose.pose.orientation.w"), at("pose.pose.orientation.x"),
                             at("pose.pose.orientation.y"), at("pose.pose.orientation.z"));
  const double seconds = at("header.stamp.sec"), rest = at("header.stamp.nanosec");
  if (!position.allFinite() || !(std::abs(q.norm() - 1) < 0.01) || !std::isfinite(seconds + rest))
    return {};
  const auto ns =
      static_cast<std::int64_t>(seconds) * 1'000'000'000 + static_cast<std::int64_t>(rest);
  return Pose{measurement::stamp_from_ns(ns), ned_of_enu(position), ned_of_enu(q), {}};
}

}  // namespace

boost::system::result<Track, Problem> read_odometry(const std::string& path,
                                                    const std::string& topic) {
  auto recording = record::Recording::open(path);
  if (!recording) return Problem{recording.error().line};
  std::map<std::string, Track> tracks;
  std::optional<record::MessageNode> layout;
  while (const auto event = recording->next()) {
    const auto* message = std::get_if<record::Understood>(&*event);
    if (message == nullptr || message->schema->name != "nav_msgs/msg/Odometry") continue;
    if (!topic.empty() && message->channel->topic != topic) continue;
    if (!layout)
      layout = record::parse_definition(message->schema->text).value_or(record::MessageNode{});
    if (const auto pose = odometry_pose(values_in(*layout, message->cdr)))
      tracks[message->channel->topic].push_back(*pose);
  }
  if (tracks.size() == 1) return tracks.begin()->second;
  std::string found;
  for (const auto& [name, track] : tracks) found.append(found.empty() ? "" : ", ").append(name);
  return Problem{fmt::format("{}: --topic names no topic of nav_msgs/Odometry, found: {}", path,
                             found.empty() ? "none" : found)};
}

}  // namespace drydock::score
