#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "drivers/recordings/record/message_layout.hpp"

using namespace drydock;

namespace {

/// Counts the values, and checks that each lies inside the message.
struct Inside {
  std::size_t size, values = 0;
  int depth = 0;

  void value(const record::MessageNode&, std::size_t offset, mcap::Bytes bytes) {
    if (offset > size || bytes.size() > size - offset || depth < 1) std::abort();
    ++values;
  }
  void begin(const record::MessageNode&, std::size_t) {}
  void end(const record::MessageNode&) {}
  void enter(const record::MessageNode&, std::size_t) { ++depth; }
  void leave(const record::MessageNode&) { --depth; }
};

}  // namespace

/// Any text as the definition of any bytes. The bytes follow the text's first 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto* end = std::find(data, data + size, 0);
  const std::string_view definition{reinterpret_cast<const char*>(data),
                                    static_cast<std::size_t>(end - data)};
  const auto layout = record::parse_definition(definition, "t/msg/M");
  if (!layout || end == data + size) return 0;
  std::vector<std::uint8_t> cdr{0, 1, 0, 0};
  cdr.insert(cdr.end(), end + 1, data + size);
  Inside visitor{cdr.size()};
  const bool whole = record::visit_message(*layout, cdr, visitor);
  if (visitor.values > cdr.size() || (whole && visitor.depth != 0)) std::abort();
  return 0;
}
