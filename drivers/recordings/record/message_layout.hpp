#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/recordings/mcap/format.hpp"

/// What a message's own definition says of its bytes: reads any ROS 2 message of a recording, ours
/// or another program's, without its type being built in.
namespace drydock::record {

enum class Scalar : std::uint8_t {
  boolean,
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64,
  text,
  nested
};

/// A field of a message, or the message itself.
struct MessageNode {
  enum class Repeat : std::uint8_t { once, array, sequence };

  std::string name;  ///< empty: the message itself
  std::string type;  ///< as in the definition: "float64", "std_msgs/Header"
  Scalar scalar = Scalar::nested;
  Repeat repeat = Repeat::once;
  std::size_t count = 1;             ///< of an array
  std::vector<MessageNode> members;  ///< of a nested message
};

/// `definition` is a schema of encoding "ros2msg". Empty: not understood.
std::optional<MessageNode> parse_definition(std::string_view definition);

/// Visits the values of a message in CDR (XCDR1, little endian) in the order of its fields:
///   visitor.value(node, offset, bytes)   a scalar, or a text without its end, at an offset in
///   `cdr` visitor.begin(node, count)           before a sequence's elements; visitor.end(node)
///   behind visitor.enter(node, offset)          before the members of each nested message;
///   leave(node)
/// False: the message is shorter than its definition, or in another encoding.
template <class Visitor>
bool visit_message(const MessageNode& message, mcap::Bytes cdr, Visitor&& visitor);

}  // namespace drydock::record

#include "drivers/recordings/record/message_visit.hpp"
