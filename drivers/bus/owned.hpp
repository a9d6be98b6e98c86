#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>

#include "drivers/bus/message_types.hpp"

/// Strings and sequences inside messages. Cyclone owns their memory; dds_sample_free releases it.
namespace drydock::bus {

inline char* copy_of(const std::string& text) { return dds_string_dup(text.c_str()); }

/// The elements are empty at first.
template <class Sequence>
auto* allocate(Sequence& sequence, std::size_t count) {
  using Element = std::remove_pointer_t<decltype(sequence._buffer)>;
  sequence._length = sequence._maximum = static_cast<std::uint32_t>(count);
  sequence._buffer = static_cast<Element*>(dds_alloc(count * sizeof(Element)));
  sequence._release = true;
  return sequence._buffer;
}

/// Empties a message for the next content, but keeps its frame name.
template <class Message>
void release_but_frame(Message& message) {
  char* const frame = std::exchange(message.header.frame_id, nullptr);
  dds_sample_free(&message, message_type<Message>.descriptor, DDS_FREE_CONTENTS);
  message = {};
  message.header.frame_id = frame;
}

}  // namespace drydock::bus
