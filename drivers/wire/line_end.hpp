#pragma once

#include <cstddef>

#include "drivers/wire/codec.hpp"

namespace drydock::wire {

/// A line that is valid up to `end`. A CR, LF or CR LF that follows is part of its frame; so is CR
/// CR LF, which a terminal that adds a CR makes of CR LF.
inline Scan with_line_end(Bytes bytes, std::size_t end) {
  if (end == bytes.size()) return Scan::need_more();
  if (bytes[end] == '\n') return Scan::frame(end + 1);
  if (bytes[end] != '\r') return Scan::frame(end);
  if (end + 1 == bytes.size()) return Scan::need_more();
  if (bytes[end + 1] == '\r') {
    if (end + 2 == bytes.size()) return Scan::need_more();
    return Scan::frame(bytes[end + 2] == '\n' ? end + 3 : end + 1);
  }
  return Scan::frame(bytes[end + 1] == '\n' ? end + 2 : end + 1);
}

}  // namespace drydock::wire
