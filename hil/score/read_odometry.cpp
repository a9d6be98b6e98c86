#include <fmt/format.h>

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>

#include "drivers/measurement/covariance.hpp"
#include "drivers/recordings/record/layouts.hpp"
#include "drivers/text/printable.hpp"
#include "hil/replay/reference/references.hpp"
#include "hil/score/axes.hpp"
#include "hil/score/passed_over.hpp"
#include "hil/score/read_estimates.hpp"

namespace drydock::score {
namespace {

using Values = std::map<std::string, double>;

/// The numbers that a pose is made of: a message of this name may have another definition.
constexpr std::array pose_fields{
    "header.stamp.sec",        "header.stamp.nanosec",    "pose.pose.position.x",
    "pose.pose.position.y",    "pose.pose.position.z",    "pose.pose.orientation.w",
    "pose.pose.orientation.x", "pose.pose.orientation.y", "pose.pose.orientation.z"};

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

/// The odometries of one topic.
class OdometryTopic {
 public:
  void read(const record::Layout& layout, mcap::Bytes cdr) {
    ++messages_;
    if (!layout) return note(layout.error().line);
    if (const auto why = record::misfit(*layout, cdr); !why.empty()) return note(why);
    Values values;
    for (const auto& [name, value] : replay::values_of(*layout, cdr))
      values[name] = value.is_number() ? value.template get<double>()
                                       : std::numeric_limits<double>::quiet_NaN();
    for (const char* field : pose_fields)
      if (!values.contains(field)) return note(fmt::format("it has no {}", field));
    take(values);
  }

  Estimates result() {
    estimates_.notes = passed_over_.notes();
    return std::move(estimates_);
  }

 private:
  void note(const std::string& why) { passed_over_.add(text::printable(why), messages_); }

  void take(const Values& v) {
    const Eigen::Vector3d position{v.at("pose.pose.position.x"), v.at("pose.pose.position.y"),
                                   v.at("pose.pose.position.z")};
    const Eigen::Quaterniond q(v.at("pose.pose.orientation.w"), v.at("pose.pose.orientation.x"),
                               v.at("pose.pose.orientation.y"), v.at("pose.pose.orientation.z"));
    const double seconds = v.at("header.stamp.sec"), rest = v.at("header.stamp.nanosec");
    if (!position.allFinite() || !(std::abs(q.norm() - 1) < 0.01))
      return note("no pose (a number is not finite, or the quaternion's length is not 1)");
    const auto ns =
        static_cast<std::int64_t>(seconds) * 1'000'000'000 + static_cast<std::int64_t>(rest);
    estimates_.track.push_back({measurement::stamp_from_ns(ns), ned_of_enu(position), ned_of_enu(q),
                                covariance(position_covariance(v))});
  }

  std::optional<Eigen::Matrix3d> covariance(const Eigen::Matrix3d& enu) {
    const auto d = enu.diagonal().array();
    if (enu.allFinite() && !((d > 0).all() && (d < 1e6).all())) {
      note("its covariance is not known (a variance is not above 0 and below 1e6)");
    } else if (const char* flaw = measurement::covariance_flaw(enu)) {
      note(fmt::format("its covariance is none: it {}", flaw));
    } else {
      return ned_of_enu(enu);
    }
    return {};
  }

  std::uint64_t messages_ = 0;
  Estimates estimates_;
  PassedOver passed_over_{"message"};
};

using Topics = std::map<std::string, OdometryTopic>;

/// A recording of a run has its own truth beside the estimates.
bool is_truth(const Topics::value_type& one) { return one.first.starts_with("/estimate/truth"); }

/// The topic with this name, or the only one that is no truth; else null.
OdometryTopic* chosen(Topics& topics, const std::string& name) {
  const auto estimates = std::ranges::count_if(topics, std::not_fn(is_truth));
  if (name.empty() && estimates != 1) return nullptr;
  const auto found = name.empty() ? std::ranges::find_if_not(topics, is_truth) : topics.find(name);
  return found == topics.end() ? nullptr : &found->second;
}

Problem which_topic(const Topics& topics, const std::string& path, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& [topic, odometry] : topics) names.push_back(text::printable(topic));
  if (names.empty()) return {fmt::format("{}: no topic of nav_msgs/Odometry in it", path)};
  if (name.empty() && std::ranges::all_of(topics, is_truth))
    return {fmt::format(
        "{}: of nav_msgs/Odometry it has only the truth, {}; give --topic to score that", path,
        fmt::join(names, ", "))};
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
  record::Layouts layouts;
  while (const auto event = recording->next()) {
    const auto* message = std::get_if<record::Understood>(&*event);
    if (message == nullptr || message->schema->name != "nav_msgs/msg/Odometry") continue;
    OdometryTopic& odometry = topics[message->channel->topic];
    if (topic.empty() || topic == message->channel->topic)
      odometry.read(layouts.of(*message), message->cdr);
  }
  OdometryTopic* found = chosen(topics, topic);
  if (found == nullptr) return which_topic(topics, path, topic);
  Estimates estimates = found->result();
  if (!recording->damage().empty()) estimates.notes.push_back(recording->damage());
  return estimates;
}

}  // namespace drydock::score
