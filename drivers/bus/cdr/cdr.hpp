#pragma once

#include <dds/ddsi/ddsi_cdrstream.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "drivers/bus/message_types.hpp"

namespace drydock::bus {

/// The bytes of so many doubles that are NaN.
inline std::vector<std::uint8_t> not_given_doubles(std::size_t count) {
  const std::vector<double> none(count, std::numeric_limits<double>::quiet_NaN());
  std::vector<std::uint8_t> bytes(count * sizeof(double));
  std::memcpy(bytes.data(), none.data(), bytes.size());
  return bytes;
}

/// Encodes messages as the bytes that DDS would send: encapsulation header 00 01 00 00 (plain CDR,
/// little endian), then XCDR1. It keeps its memory: it allocates no more once it has seen the
/// largest message.
class CdrEncoder {
 public:
  CdrEncoder() { dds_ostreamLE_init(&stream_, 0, xcdr1); }
  CdrEncoder(const CdrEncoder&) = delete;
  CdrEncoder& operator=(const CdrEncoder&) = delete;
  ~CdrEncoder() { dds_ostreamLE_fini(&stream_); }

  /// The bytes are valid until the next call.
  template <class Message>
  std::span<const std::uint8_t> encode(const Message& message) {
    // Alignment counts from the end of the header: the header has 4 bytes, and doubles align to 8.
    stream_.x.m_index = 0;
    dds_stream_writeLE(&stream_, reinterpret_cast<const char*>(&message),
                       message_type<Message>.descriptor->m_ops);
    bytes_.assign(header.begin(), header.end());
    bytes_.insert(bytes_.end(), stream_.x.m_buffer, stream_.x.m_buffer + stream_.x.m_index);
    return bytes_;
  }

 private:
  static constexpr std::uint32_t xcdr1 = 1;
  static constexpr std::array<std::uint8_t, 4> header{0, 1, 0, 0};
  dds_ostreamLE_t stream_{};
  std::vector<std::uint8_t> bytes_;
};

/// The fields that a type got at its end in a later version, with the values of "not given". Older
/// recordings have messages without them.
template <class Message>
inline const std::vector<std::uint8_t> later_fields{};
template <>
inline const std::vector<std::uint8_t> later_fields<BottomTrackMessage> = not_given_doubles(10);
template <>
inline const std::vector<std::uint8_t> later_fields<WaterSpeedMessage> = not_given_doubles(1);
template <>
inline const std::vector<std::uint8_t> later_fields<GnssFixMessage>{0};

/// Decodes messages from such bytes, wherever the bytes come from, also those of older versions. It
/// keeps its memory for the next message.
template <class Message>
class CdrDecoder {
 public:
  CdrDecoder() = default;
  CdrDecoder(const CdrDecoder&) = delete;
  CdrDecoder& operator=(const CdrDecoder&) = delete;
  ~CdrDecoder() { dds_sample_free(&message_, message_type<Message>.descriptor, DDS_FREE_CONTENTS); }

  /// Null if the bytes are not plain CDR, little endian, of this type. Valid until the next call.
  const Message* decode(std::span<const std::uint8_t> cdr) {
    constexpr std::size_t header = 4;
    if (cdr.size() <= header || cdr[0] != 0 || cdr[1] != 1) return nullptr;
    bytes_.assign(cdr.begin() + header, cdr.end());
    if (!checked_size() && !sound_with_later_fields()) return nullptr;
    dds_istream_t stream;
    dds_istream_init(&stream, static_cast<std::uint32_t>(bytes_.size()), bytes_.data(), xcdr1);
    dds_stream_read(&stream, reinterpret_cast<char*>(&message_),
                    message_type<Message>.descriptor->m_ops);
    return &message_;
  }

 private:
  static constexpr std::uint32_t xcdr1 = 1;

  /// The bytes that the message takes; empty if they are none. Cyclone reads only what this has
  /// checked: lengths, ends of strings, enumerators.
  std::optional<std::size_t> checked_size() {
    std::uint32_t checked = 0;
    if (dds_stream_normalize_data(reinterpret_cast<char*>(bytes_.data()), &checked,
                                  static_cast<std::uint32_t>(bytes_.size()), false, xcdr1,
                                  message_type<Message>.descriptor->m_ops) == nullptr)
      return {};
    return checked;
  }

  /// True if the bytes are those of an older version: then they now have the later fields too.
  bool sound_with_later_fields() {
    const auto& later = later_fields<Message>;
    if (later.empty()) return false;
    bytes_.insert(bytes_.end(), later.begin(), later.end());
    return checked_size() == bytes_.size();
  }

  Message message_{};
  std::vector<std::uint8_t> bytes_;
};

}  // namespace drydock::bus
