#pragma once

#include <boost/endian/conversion.hpp>
#include <cstring>
#include <optional>

#include "drivers/recordings/mcap/format.hpp"

namespace drydock::mcap {

/// Reads fields from a record's content. After the first field that does not fit, every result is
/// empty and `good()` is false.
class Decoder {
 public:
  explicit Decoder(Bytes bytes) : rest_(bytes) {}

  template <class Number>
  Number number() {
    Number value{};
    const Bytes raw = take(sizeof value);
    if (!raw.empty()) std::memcpy(&value, raw.data(), sizeof value);
    return boost::endian::little_to_native(value);
  }
  std::string text() { return string(take(number<std::uint32_t>())); }
  Bytes bytes(std::uint64_t size) { return take(size); }
  Map map() {
    Decoder entries(take(number<std::uint32_t>()));
    Map all;
    while (entries.good() && !entries.rest_.empty()) {
      auto key = entries.text();
      all.emplace_back(std::move(key), entries.text());
    }
    good_ = good_ && entries.good();
    return all;
  }
  Bytes rest() { return take(rest_.size()); }
  bool good() const { return good_; }

  static std::string string(Bytes bytes) { return {bytes.begin(), bytes.end()}; }

 private:
  Bytes take(std::uint64_t size) {
    if (size > rest_.size()) {
      good_ = false;
      rest_ = {};
    }
    if (!good_) return {};
    const Bytes taken = rest_.first(static_cast<std::size_t>(size));
    rest_ = rest_.subspan(static_cast<std::size_t>(size));
    return taken;
  }

  Bytes rest_;
  bool good_ = true;
};

/// The content of a record. Empty if the content is too short, if an attachment's CRC is wrong, or
/// if `Record` has no type for the opcode.
std::optional<Record> decode(Opcode opcode, Bytes content);

}  // namespace drydock::mcap
