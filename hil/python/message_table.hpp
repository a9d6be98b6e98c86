#pragma once

#include <unordered_map>

#include "drivers/recordings/record/message_layout.hpp"
#include "drivers/recordings/record/recording.hpp"
#include "hil/python/columns.hpp"

namespace drydock::python {

/// The messages of one topic of a recording, by the definition in the recording. Members of nested
/// messages are `pose.position.x`; an array of numbers is a row.
class MessageTable {
 public:
  /// The layout must outlive the table.
  explicit MessageTable(const record::MessageNode& layout);

  /// Why the message does not fit the definition; empty: it does.
  std::string add(const record::Understood& message);
  py::dict take() { return columns_.take(); }

 private:
  class Visitor;
  void name(const record::MessageNode& node, const std::string& path);

  const record::MessageNode& layout_;
  std::unordered_map<const record::MessageNode*, std::string> names_;
  Columns columns_;
};

}  // namespace drydock::python
