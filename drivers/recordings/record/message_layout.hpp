#pragma once

#include <boost/system/result.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/recordings/mcap/format.hpp"

/// Decodes any ROS 2 message of a recording by the definition in the recording. It may come from
/// Drydock or another program; the type need not be compiled in.
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
  std::size_t count = 1;             ///< for an array
  std::vector<MessageNode> members;  ///< for a nested message
};

/// Why messages cannot be read, as one line about them: "its definition does not have t/Pose".
struct LayoutTrouble {
  std::string line;
};
[[noreturn]] void throw_exception_from_error(const LayoutTrouble& trouble,
                                             const boost::source_location& where);

/// `definition` is a schema with encoding "ros2msg" of the type `type`, "nav_msgs/msg/Odometry": a
/// bare name in it is of the package that names it.
boost::system::result<MessageNode, LayoutTrouble> parse_definition(std::string_view definition,
                                                                   std::string_view type);

/// Visits the values of a message in CDR (XCDR1, little endian) in the order of its fields:
///  visitor.value(node, offset, bytes)  for a scalar or a text without its end, at an offset in
///  `cdr` visitor.begin(node, count)          before the elements of a sequence visitor.end(node)
///  after the elements of a sequence visitor.enter(node, offset)         before the members of each
///  nested message visitor.leave(node)                 after the members of each nested message
/// False if the message is shorter than its definition, or has another encoding.
template <class Visitor>
bool visit_message(const MessageNode& message, mcap::Bytes cdr, Visitor&& visitor);

/// Why visit_message() is false, as one line about the message; empty if it is true.
std::string misfit(const MessageNode& message, mcap::Bytes cdr);

}  // namespace drydock::record

#include "drivers/recordings/record/message_visit.hpp"
