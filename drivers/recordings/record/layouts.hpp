#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "drivers/recordings/record/message_layout.hpp"
#include "drivers/recordings/record/recording.hpp"

namespace drydock::record {

using Layout = boost::system::result<MessageNode, LayoutTrouble>;

/// The layout of a channel's messages, from the definition in the recording.
Layout layout_of(const mcap::Channel& channel, const mcap::Schema& schema);

/// The layouts of a recording's messages, each made once.
class Layouts {
 public:
  /// Valid as long as this object.
  const Layout& of(const Understood& message);

 private:
  std::map<std::uint16_t, Layout> by_channel_;
};

/// Counts the messages that could not be read, by topic and reason.
class Unread {
 public:
  void add(const std::string& topic, const std::string& why) { ++counts_[{topic, why}]; }
  /// "/odom: 5 messages are not read: it ends before its definition does", a line each,
  /// with names from the recording.
  std::vector<std::string> notes() const;

 private:
  std::map<std::pair<std::string, std::string>, std::uint64_t> counts_;
};

}  // namespace drydock::record
