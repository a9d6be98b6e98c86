#pragma once

#include <optional>
#include <variant>

#include "drivers/wire/described/codec.hpp"
#include "drivers/wire/described/description.hpp"

namespace drydock::wire::described {

/// A description with the interface of the codecs of the registry, where those are values: for what
/// runs any protocol.
struct DescribedCodec {
  static constexpr std::size_t max_frame = longest_frame;
  using Message = std::variant<Record>;

  explicit DescribedCodec(DescriptionPtr described)
      : description(std::move(described)), name(description->name) {}

  Scan scan(Bytes bytes) const { return described::scan(description->plan, bytes); }
  std::optional<Message> decode(Bytes frame) const {
    std::optional<Message> message(std::in_place);
    auto& record = std::get<Record>(*message);
    if (described::decode(description->plan, frame, record) != Decoded::message) message.reset();
    return message;
  }

  /// Calls `unread(id)` for each record of a valid frame that its message does not describe.
  template <class F>
  void unread_blocks(Bytes frame, F&& unread) const {
    described::unread_records(description->plan, frame, unread);
  }

  DescriptionPtr description;
  std::string_view name;
};

}  // namespace drydock::wire::described
