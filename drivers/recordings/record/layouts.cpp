#include "drivers/recordings/record/layouts.hpp"

#include <fmt/format.h>

namespace drydock::record {

Layout layout_of(const mcap::Channel& channel, const mcap::Schema& schema) {
  if (channel.encoding != "cdr")
    return LayoutTrouble{
        fmt::format("it is encoded as '{}', and only 'cdr' is read", channel.encoding)};
  if (schema.text.empty() && schema.encoding != "ros2msg")
    return LayoutTrouble{"the recording has no definition of it"};
  if (schema.encoding != "ros2msg")
    return LayoutTrouble{
        fmt::format("its definition is in '{}', and only 'ros2msg' is read", schema.encoding)};
  return parse_definition(schema.text, schema.name);
}

const Layout& Layouts::of(const Understood& message) {
  const auto found = by_channel_.find(message.channel->id);
  if (found != by_channel_.end()) return found->second;
  return by_channel_.emplace(message.channel->id, layout_of(*message.channel, *message.schema))
      .first->second;
}

std::vector<std::string> Unread::notes() const {
  std::vector<std::string> notes;
  for (const auto& [what, count] : counts_)
    notes.push_back(
        count == 1
            ? fmt::format("{}: 1 message is not read: {}", what.first, what.second)
            : fmt::format("{}: {} messages are not read: {}", what.first, count, what.second));
  return notes;
}

}  // namespace drydock::record
