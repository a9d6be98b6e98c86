#pragma once

#include <cstddef>

#include "drivers/wire/codec.hpp"

namespace drydock::wire {

/// A line that is valid up to `end`. A CR, LF or CR LF that follows is part of its frame.
inline Scan with_line_end(Bytes bytes, std::size_t end) {
  if (end == bytes.size()) return Scan::need_more();
  if (bytes[end] == '\n') return Scan::frame(end + 1);
  if (bytes[end] != '\r') return Scan::frame(end);
  if (end + 1 == bytes.size()) return Scan::need_more();
  return Scan::frame(bytes[end + 1] == '\n' ? end + 2 : end + 1);
}

}  // namespace drydock::wire
