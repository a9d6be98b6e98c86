#include <fmt/format.h>

#include <fmt/ranges.h>

#include <map>

#include "drivers/recordings/record/message_layout.hpp"
#include "drivers/recordings/record/recording.hpp"
#include "drivers/text/printable.hpp"
#include "hil/replay/reference/references.hpp"
#include "hil/score/axes.hpp"
#include "hil/score/passed_over.hpp"
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

/// ROS says "not known" as zeros, as a variance of -1, or as 1e6 and more.
std::optional<Eigen::Matrix3d> known(const Eigen::Matrix3d& covariance) {
  const auto d = covariance.diagonal().array();
  if (!covariance.allFinite() || !(d > 0).all() || !(d < 1e6).all()) return {};
  return covariance;
}

/// Of the position: the first three rows and columns of six.
Eigen::Matrix3d position_covariance(const Values& v) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      const auto found = v.find(fmt::format("pose.covariance[{}]", 6 * row + column));
      if (found != v.end()) covariance(row, column) = found->second;
    }
  return covariance;
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
  Pose pose{measurement::stamp_from_ns(ns), ned_of_enu(position), ned_of_enu(q), {}};
  if (const auto covariance = known(position_covariance(v)))
    pose.covariance_m2 = ned_of_enu(*covariance);
  return pose;
}

/// The odometries of one topic.
struct OdometryTopic {
  std::uint64_t messages = 0;
  Estimates estimates;
  PassedOver passed_over{"message"};

  void take(const std::optional<Pose>& pose) {
    ++messages;
    if (pose)
      estimates.track.push_back(*pose);
    else
      passed_over.add("no pose (a number is not finite, or the quaternion's length is not 1)",
                      messages);
  }
};

using Topics = std::map<std::string, OdometryTopic>;

/// The topic with this name, or the only one; else null.
OdometryTopic* chosen(Topics& topics, const std::string& name) {
  if (name.empty()) return topics.size() == 1 ? &topics.begin()->second : nullptr;
  const auto found = topics.find(name);
  return found == topics.end() ? nullptr : &found->second;
}

Problem which_topic(const Topics& topics, const std::string& path, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& [topic, odometry] : topics) names.push_back(text::printable(topic));
  if (names.empty()) return {fmt::format("{}: no topic of nav_msgs/Odometry in it", path)};
  return {fmt::format("{}: {}; give --topic, one of: {}", path,
                      name.empty() ? "several topics of nav_msgs/Odometry"
                                   : fmt::format("no topic '{}' of nav_msgs/Odometry", name),
                      fmt::join(names, ", "))};
}

}  // namespace

boost::system::result<Estimates, Problem> read_odometry(const std::string& path,
                                                        const std::string& topic) {
  auto recording = record::Recording::open(path);
  if (!recording) return Problem{recording.error().line};
  Topics topics;
  std::optional<record::MessageNode> layout;
  while (const auto event = recording->next()) {
    const auto* message = std::get_if<record::Understood>(&*event);
    if (message == nullptr || message->schema->name != "nav_msgs/msg/Odometry") continue;
    if (!layout)
      layout = record::parse_definition(message->schema->text).value_or(record::MessageNode{});
    OdometryTopic& odometry = topics[message->channel->topic];
    if (topic.empty() || topic == message->channel->topic)
      odometry.take(odometry_pose(values_in(*layout, message->cdr)));
  }
  OdometryTopic* found = chosen(topics, topic);
  if (found == nullptr) return which_topic(topics, path, topic);
  found->estimates.notes = found->passed_over.notes();
  if (!recording->damage().empty()) found->estimates.notes.push_back(recording->damage());
  return std::move(found->estimates);
}

}  // namespace drydock::score
