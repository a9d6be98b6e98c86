#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// MCAP, the container for recordings (specification: mcap.dev/spec, version 0). A file is a
/// sequence of records. A record has one byte of opcode, 64 bits of length, and its content. All
/// numbers are little-endian.
namespace drydock::mcap {

using Bytes = std::span<const std::uint8_t>;
using Buffer = std::vector<std::uint8_t>;
/// Key and value, in the order in which they are written.
using Map = std::vector<std::pair<std::string, std::string>>;

inline constexpr std::array<std::uint8_t, 8> magic{0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
inline constexpr std::size_t record_head = 9;  ///< bytes of opcode and length

enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0A,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F
};

struct Header {
  std::string profile, library;
};

struct Schema {
  std::uint16_t id = 0;  ///< never 0 in a file
  std::string name, encoding, text;
};

struct Channel {
  std::uint16_t id = 0, schema = 0;
  std::string topic, encoding;
  Map metadata;
};

/// Readers take a later time as this one, so that the difference of two times fits: in 2116.
inline constexpr std::uint64_t latest_time = std::uint64_t{INT64_MAX} / 2;

/// Times are in ns since 1970. The caller owns `data`.
struct Message {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0, publish_time = 0;
  Bytes data;
};

struct Attachment {
  std::uint64_t log_time = 0, create_time = 0;
  std::string name, media_type, data;
};

struct Metadata {
  std::string name;
  Map values;
};

/// Ends the data; after it come only indexes.
struct DataEnd {};

using Record = std::variant<Header, Schema, Channel, Message, Attachment, Metadata, DataEnd>;

}  // namespace drydock::mcap
