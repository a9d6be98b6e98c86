#include <fmt/format.h>

#include <algorithm>

#include "drivers/wire/described/description.hpp"
#include "rig_config/checks/checks.hpp"

namespace drydock::rig_config {
namespace {

using wire::described::Description;
using wire::described::Message;

const Message* reply_of(const Description& description, const std::string& name) {
  const auto& messages = description.plan.messages;
  const auto found = std::ranges::find(messages, name, &Message::name);
  return found == messages.end() ? nullptr : &*found;
}

/// True if an answer to a poll of the one begins as an answer to a poll of the other.
bool have_like_answers(const Description& one, const Description& other) {
  return std::ranges::any_of(one.poll, [&](const auto& poll) {
    const Message* const answer = reply_of(one, poll.reply);
    return answer && std::ranges::any_of(other.poll, [&](const auto& second) {
             const Message* const like = reply_of(other, second.reply);
             return like &&
                    (like->head.starts_with(answer->head) || answer->head.starts_with(like->head));
           });
  });
}

}  // namespace

Problems check_polled_lines(const Node& root, const std::string& file,
                            const std::vector<DeviceConfig>& all) {
  Problems problems;
  for_each_table(root, "device", [&](const Node& table, std::size_t i) {
    const Node* const link = table.find("link");
    if (!link || !all[i].description) return;
    for (std::size_t j = 0; j < i; ++j) {
      if (all[j].link != all[i].link || !all[j].description) continue;
      if (!have_like_answers(*all[j].description, *all[i].description)) continue;
      problems.push_back(
          {file, link->at.line, link->at.column, fmt::format("/device/{}/link", i),
           fmt::format("'{}' asks on this link too, and the answers to both begin alike, so that "
                       "nobody can tell whose they are, allowed: a link of its own",
                       all[j].name)});
      return;
    }
  });
  return problems;
}

}  // namespace drydock::rig_config
