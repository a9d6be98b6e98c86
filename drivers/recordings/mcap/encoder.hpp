#pragma once

#include <boost/endian/conversion.hpp>
#include <string_view>

#include "drivers/recordings/mcap/format.hpp"

namespace drydock::mcap {

/// Appends fields and records to a buffer.
class Encoder {
 public:
  explicit Encoder(Buffer& out) : out_(out) {}

  template <class Number>
  Encoder& number(Number value) {
    boost::endian::native_to_little_inplace(value);
    const auto at = out_.size();
    out_.resize(at + sizeof value);
    std::memcpy(out_.data() + at, &value, sizeof value);
    return *this;
  }
  Encoder& raw(Bytes bytes) {
    out_.insert(out_.end(), bytes.begin(), bytes.end());
    return *this;
  }
  Encoder& raw(std::string_view text) { return raw(Bytes{bytes_of(text), text.size()}); }
  Encoder& text(std::string_view value) {
    return number(static_cast<std::uint32_t>(value.size())).raw(value);
  }
  Encoder& map(const Map& entries) {
    return sized<std::uint32_t>([&] {
      for (const auto& [key, value] : entries) text(key).text(value);
    });
  }
  /// Writes the length and then the output of `body`.
  template <class Length, class Body>
  Encoder& sized(Body body) {
    const auto at = out_.size();
    number(Length{0});
    body();
    Length length = static_cast<Length>(out_.size() - at - sizeof(Length));
    boost::endian::native_to_little_inplace(length);
    std::memcpy(out_.data() + at, &length, sizeof length);
    return *this;
  }
  template <class Body>
  Encoder& record(Opcode opcode, Body body) {
    return number(static_cast<std::uint8_t>(opcode)).template sized<std::uint64_t>(body);
  }

 private:
  static const std::uint8_t* bytes_of(std::string_view text) {
    return reinterpret_cast<const std::uint8_t*>(text.data());
  }
  Buffer& out_;
};

void encode(Buffer& out, const Header& header);
void encode(Buffer& out, const Schema& schema);
void encode(Buffer& out, const Channel& channel);
void encode(Buffer& out, const Message& message);
void encode(Buffer& out, const Attachment& attachment);  ///< with its CRC
void encode(Buffer& out, const Metadata& metadata);

std::uint32_t crc32(Bytes bytes);  ///< CRC of zlib; MCAP uses it everywhere

}  // namespace drydock::mcap
