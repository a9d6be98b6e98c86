#pragma once

#include <optional>

#include "drivers/wire/nmea0183/nmea0183.hpp"

namespace drydock::wire {

/// Decodes a sentence into a variant with at least the messages of Nmea0183.
template <class Variant>
std::optional<Variant> decode_nmea0183(Bytes frame) {
  SentenceReader fields{frame};
  const auto formatter = fields.formatter();
  const auto is_it = [=]<class M>() { return M::type == formatter; };
  return read_one_of<Variant>(Nmea0183Messages{}, is_it, fields);
}

}  // namespace drydock::wire
