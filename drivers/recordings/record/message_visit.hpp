#pragma once

#include <optional>

#include "drivers/recordings/record/message_layout.hpp"
#include "drivers/wire/bytes.hpp"

namespace drydock::record {

/// Size of a scalar in bytes, which is also its alignment. 0 for types without a fixed size.
constexpr std::size_t size_of(Scalar scalar) {
  switch (scalar) {
    case Scalar::boolean:
    case Scalar::int8:
    case Scalar::uint8: return 1;
    case Scalar::int16:
    case Scalar::uint16: return 2;
    case Scalar::int32:
    case Scalar::uint32:
    case Scalar::float32: return 4;
    case Scalar::int64:
    case Scalar::uint64:
    case Scalar::float64: return 8;
    case Scalar::text:
    case Scalar::nested: return 0;
  }
  return 0;
}

template <class Visitor>
class MessageWalk {
 public:
  MessageWalk(mcap::Bytes cdr, Visitor& visitor) : cdr_(cdr), visitor_(visitor) {}

  bool node(const MessageNode& node) {
    using Repeat = MessageNode::Repeat;
    std::size_t count = node.repeat == Repeat::array ? node.count : 1;
    if (node.repeat == Repeat::sequence) {
      const auto length = number();
      if (!length || *length > cdr_.size()) return false;
      count = *length;
      visitor_.begin(node, count);
    }
    for (std::size_t i = 0; i < count; ++i)
      if (!element(node)) return false;
    if (node.repeat == Repeat::sequence) visitor_.end(node);
    return true;
  }

 private:
  static constexpr std::size_t head = 4;  ///< alignment counts from the end of the header

  bool element(const MessageNode& node) {
    if (node.scalar == Scalar::nested) {
      visitor_.enter(node, at_);
      for (const auto& member : node.members)
        if (!this->node(member)) return false;
      visitor_.leave(node);
      return true;
    }
    if (node.scalar == Scalar::text) {
      const auto length = number();
      return length && *length > 0 && take(node, *length, 1);
    }
    align(size_of(node.scalar));
    return take(node, size_of(node.scalar), 0);
  }

  bool take(const MessageNode& node, std::size_t size, std::size_t end) {
    if (at_ > cdr_.size() || size > cdr_.size() - at_) return false;
    visitor_.value(node, at_, cdr_.subspan(at_, size - end));
    at_ += size;
    return true;
  }

  void align(std::size_t size) { at_ = head + (at_ - head + size - 1) / size * size; }

  std::optional<std::uint32_t> number() {
    align(sizeof(std::uint32_t));
    if (at_ + sizeof(std::uint32_t) > cdr_.size()) return {};
    at_ += sizeof(std::uint32_t);
    return wire::load_le<std::uint32_t>(cdr_, at_ - sizeof(std::uint32_t));
  }

  mcap::Bytes cdr_;
  Visitor& visitor_;
  std::size_t at_ = head;
};

template <class Visitor>
bool visit_message(const MessageNode& message, mcap::Bytes cdr, Visitor&& visitor) {
  return cdr.size() >= 4 && cdr[0] == 0 && cdr[1] == 1 &&
         MessageWalk<Visitor>(cdr, visitor).node(message);
}

}  // namespace drydock::record
