#include "hil/score/topic_choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "drivers/text/printable.hpp"

namespace drydock::score {
namespace {

using Names = std::vector<std::string>;

bool is_truth(const std::string& topic) { return topic.starts_with("/estimate/truth"); }

/// "/imu/data" of the device imu.
bool is_measurement(const std::string& topic, const std::set<std::string>& devices) {
  return topic.starts_with('/') && devices.contains(topic.substr(1, topic.find('/', 1) - 1));
}

/// "/estimate/NAME" of "/estimate/NAME/odometry"; empty: of no run's estimator.
std::string estimator_of(const std::string& topic) {
  constexpr std::string_view before = "/estimate/";
  return topic.starts_with(before) ? topic.substr(0, topic.find('/', before.size()))
                                   : std::string();
}

Names names_of(const EstimateTopics& topics) {
  Names names;
  for (const auto& [name, type] : topics) names.push_back(text::printable(name));
  return names;
}

std::string type_names() {
  Names names;
  for (const auto& type : message_types()) names.push_back(type.short_name());
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Those of the type that tells most.
EstimateTopics best_of(const EstimateTopics& topics) {
  EstimateTopics best;
  for (const auto& type : message_types()) {
    for (const auto& one : topics)
      if (one.second == &type) best.insert(one);
    if (!best.empty()) break;
  }
  return best;
}

EstimateTopics estimates_in(const EstimateTopics& topics, const std::set<std::string>& devices) {
  EstimateTopics estimates = topics;
  std::erase_if(estimates, [&](const auto& one) {
    return is_truth(one.first) || is_measurement(one.first, devices);
  });
  return estimates;
}

/// With the other topics of its estimator.
TopicChoice with_siblings(const std::string& chosen, const EstimateTopics& estimates) {
  TopicChoice choice{{chosen}, {}};
  EstimateTopics others = estimates;
  others.erase(chosen);
  for (const auto& type : message_types())
    for (const auto& [name, its_type] : estimates)
      if (its_type == &type && name != chosen && !estimator_of(name).empty() &&
          estimator_of(name) == estimator_of(chosen)) {
        choice.topics.push_back(name);
        others.erase(name);
      }
  if (!others.empty())
    choice.note = fmt::format("read is {}; --topic takes another one: {}", text::printable(chosen),
                              fmt::join(names_of(others), ", "));
  return choice;
}

}  // namespace

boost::system::result<TopicChoice, Problem> choose_topics(const EstimateTopics& topics,
                                                          const std::set<std::string>& devices,
                                                          const std::string& wanted) {
  const auto names = names_of(topics);
  if (topics.contains(wanted)) return TopicChoice{{wanted}, {}};
  if (topics.empty()) return Problem{fmt::format("no topic of {} in it", type_names())};
  if (!wanted.empty())
    return Problem{fmt::format("no topic '{}' of {}; give --topic, one of: {}", wanted,
                               type_names(), fmt::join(names, ", "))};
  const auto estimates = estimates_in(topics, devices);
  if (estimates.empty())
    return Problem{fmt::format("no estimates in it, only {}; give --topic to score one of them",
                               fmt::join(names, ", "))};
  const auto best = best_of(estimates);
  if (best.size() > 1)
    return Problem{fmt::format("several topics of {}; give --topic, one of: {}",
                               best.begin()->second->short_name(),
                               fmt::join(names_of(estimates), ", "))};
  return with_siblings(best.begin()->first, estimates);
}

}  // namespace drydock::score
