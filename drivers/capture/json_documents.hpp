#pragma once

#include <vector>

#include "drivers/wire/codec.hpp"

namespace drydock::capture {

/// JSON objects that stand in a list, or over several lines, as a program that keeps a device's
/// lines writes them anew (RFC 8259): one object a line, without the blanks outside of its texts,
/// as the device sent it. Feed the blocks in order.
class JsonDocuments {
 public:
  static bool recognises(wire::Bytes text);

  /// Valid until the next call.
  wire::Bytes of(wire::Bytes block);

 private:
  void take(char letter);
  void take_outside(char letter);
  void take_brace(char letter);
  void put(char letter) { lines_.push_back(static_cast<std::uint8_t>(letter)); }
  void end_line();

  std::vector<std::uint8_t> lines_;
  int depth_ = 0;
  bool in_text_ = false, escaped_ = false;
  char before_ = '\0';  ///< in this object, without blanks
};

}  // namespace drydock::capture
