#include "hil/python/message_table.hpp"

#include <cstring>

namespace drydock::python {
namespace {

using record::MessageNode;
using record::Scalar;

template <class Number>
Number read(mcap::Bytes bytes) {
  Number number;
  std::memcpy(&number, bytes.data(), sizeof number);
  return number;
}

/// Calls `put` with a bool, std::int64_t, std::uint64_t, double or std::string_view.
template <class Put>
void with_value(Scalar scalar, mcap::Bytes bytes, Put&& put) {
  switch (scalar) {
    case Scalar::boolean: return put(read<std::uint8_t>(bytes) != 0);
    case Scalar::int8: return put(std::int64_t{read<std::int8_t>(bytes)});
    case Scalar::uint8: return put(std::int64_t{read<std::uint8_t>(bytes)});
    case Scalar::int16: return put(std::int64_t{read<std::int16_t>(bytes)});
    case Scalar::uint16: return put(std::int64_t{read<std::uint16_t>(bytes)});
    case Scalar::int32: return put(std::int64_t{read<std::int32_t>(bytes)});
    case Scalar::uint32: return put(std::int64_t{read<std::uint32_t>(bytes)});
    case Scalar::int64: return put(read<std::int64_t>(bytes));
    case Scalar::uint64: return put(read<std::uint64_t>(bytes));
    case Scalar::float32: return put(double{read<float>(bytes)});
    case Scalar::float64: return put(read<double>(bytes));
    case Scalar::text:
      return put(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    case Scalar::nested: return;
  }
}

}  // namespace

class MessageTable::Visitor {
 public:
  explicit Visitor(MessageTable& table) : table_(table) {}

  void value(const MessageNode& node, std::size_t, mcap::Bytes bytes) {
    const std::string& name = table_.names_.at(&node);
    const bool in_row = node.repeat == MessageNode::Repeat::array;
    with_value(node.scalar, bytes, [&](auto value) {
      if constexpr (std::is_arithmetic_v<decltype(value)>) {
        if (in_row) return put_in_row(name, node.count, static_cast<double>(value));
      }
      table_.columns_.field(name, value);
    });
  }
  void begin(const MessageNode& node, std::size_t count) {
    table_.columns_.end_sequence(table_.names_.at(&node), count);
  }
  void end(const MessageNode&) {}
  void enter(const MessageNode&, std::size_t) {}
  void leave(const MessageNode&) {}

 private:
  void put_in_row(const std::string& name, std::size_t width, double value) {
    row_.push_back(value);
    if (row_.size() < width) return;
    table_.columns_.append(name, row_);
    row_.clear();
  }

  MessageTable& table_;
  std::vector<double> row_;
};

MessageTable::MessageTable(const MessageNode& layout) : layout_(layout) { name(layout_, ""); }

void MessageTable::name(const MessageNode& node, const std::string& path) {
  names_[&node] = path;
  for (const auto& member : node.members)
    name(member, path.empty() ? member.name : path + "." + member.name);
}

std::string MessageTable::add(const record::Understood& message) {
  // A message that breaks off would leave columns of unequal lengths.
  if (auto why = record::misfit(layout_, message.cdr); !why.empty()) return why;
  columns_.begin_row();
  columns_.field("log_time_ns", message.at.time_since_epoch().count());
  record::visit_message(layout_, message.cdr, Visitor(*this));
  return {};
}

}  // namespace drydock::python
