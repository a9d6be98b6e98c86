#pragma once

#include <algorithm>
#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/wire/described/checksums.hpp"
#include "drivers/wire/described/flat_texts.hpp"
#include "drivers/wire/described/line_pattern.hpp"
#include "drivers/wire/described/notation.hpp"
#include "drivers/wire/described/stuffing.hpp"
#include "drivers/wire/described/targets.hpp"

/// A protocol that a file describes, as the codec runs it: flat lists of messages and of their
/// fields. rig_config/device_description reads the file and proves what the codec relies on.
namespace drydock::wire::described {

inline constexpr std::size_t most_fields = 32, most_messages = 64;

enum class Form : std::uint8_t { sentences, binary, lines, frames };

enum class Type : std::uint8_t {
  number,      ///< decimal text
  hex,         ///< hexadecimal text, with or without 0x
  hex_signed,  ///< the same in two's complement, of as many bits as its digits have
  text,        ///< any text; only shown
  constant,    ///< exactly `text`, in a binary message the integer `idle`
  sign,        ///< text: `text` where the field `sign_of` is positive, `minus` where it is negative
  ignored,
  unsigned_integer,
  signed_integer,
  real,   ///< IEEE 754, 4 or 8 bytes
  bcd,    ///< two decimal digits a byte
  septet  ///< seven bits a byte, the highest is 0
};

/// Which contents of a field say that the message's measurements are valid.
struct Validity {
  std::vector<std::string> good_texts;
  std::vector<double> good_numbers;
  std::optional<double> above;
  std::string bad_text;  ///< what an emulated device sends without a measurement
  double bad_number = 0;
};

struct Field {
  std::string key;  ///< in `drydock decode`; empty: not shown
  Type type = Type::number;
  std::string text;       ///< of a constant, or what an emulated device sends
  std::string before;     ///< text: what stands in front of the number
  char end = 0;           ///< text: the character behind the field; 0: the end of the message
  bool closed = false;    ///< text: `end` stands behind it at the end of the message too
  bool optional = false;  ///< text: the message may end before it
  std::uint16_t at = 0;   ///< binary: first byte; frames: the signal; a pattern: the group
  std::uint8_t size = 0;  ///< binary: bytes
  bool big_endian = false;
  bool low_word_first = false;           ///< binary: its 16-bit words stand in the other order
  std::optional<std::uint16_t> record;   ///< binary: `at` counts in the content of this record
  std::uint8_t first_bit = 0, bits = 0;  ///< a part of the integer; bits 0: all of it
  double factor = 1, offset = 0;         ///< value = number * factor + offset
  std::vector<double> no_value;          ///< numbers on the wire that are none
  std::optional<Target> target;
  std::uint8_t rank = 1;  ///< of fields with one target the lowest with a value counts
  std::optional<std::uint8_t> divisor;  ///< the field of this message by which it is divided
  std::optional<std::uint8_t> part_of;  ///< the field of this message to which it is added
  double part_factor = 1;               ///< SI value of one of it
  bool has_parts = false;               ///< another field is added to it
  std::optional<Validity> validity;
  std::uint8_t sign_of = 0;              ///< of a sign: the field of this message that it has
  std::string minus;                     ///< of a sign
  bool signed_apart = false;             ///< a sign of another field has this one's
  Notation notation;                     ///< text: of a number that no factor turns into SI
  std::uint8_t decimals = 3, width = 0;  ///< as an emulated device writes it
  char sign = 0;    ///< and before a number that is not negative: '+', ' '; 0: nothing
  double idle = 0;  ///< number that an emulated device sends without target
};

/// The length of a binary frame: fixed, a field of it plus a constant, or any, where delimiters
/// tell it.
struct Length {
  std::uint16_t fixed = 0;
  std::uint16_t at = 0;
  std::uint8_t size = 0;  ///< bytes of the field; 0: fixed
  bool big_endian = false;
  std::uint16_t plus = 0;

  bool is_any() const { return size == 0 && fixed == 0; }
};

/// Parts of a binary message that come in any order, each behind its identifier and its length; or
/// blocks in a fixed order, of which a mask says which are there. Their identifiers are its bits.
struct Records {
  std::uint16_t from = 0;                ///< first byte of the first one
  std::uint16_t mask_at = 0;             ///< of blocks
  std::uint8_t mask_size = 0;            ///< bytes
  std::vector<std::uint8_t> sizes = {};  ///< bytes of the block of each bit; empty: no blocks
  std::uint8_t id_at = 0, id_size = 0, length_at = 0, length_size = 0;
  bool big_endian = false;
  std::uint8_t plus = 0;  ///< bytes of a record that its length does not count

  bool are_blocks() const { return !sizes.empty(); }
  std::size_t header() const {
    return std::max(id_at + std::size_t{id_size}, length_at + std::size_t{length_size});
  }
};

/// A checksum of the header alone, of its bytes from `from` to before `to`: a length that is
/// damaged is seen before the message that it promises.
struct HeaderChecksum {
  Checksum checksum;
  std::uint16_t at = 0, from = 0, to = 0;

  std::size_t end() const { return std::max<std::size_t>(to, at + checksum.size()); }
};

/// A character of a talker, the two behind the first of a sentence: $GPHDG.
constexpr bool is_talker(std::uint8_t c) { return c >= 'A' && c <= 'Z'; }

struct Message {
  std::string name;
  std::string head;         ///< text or sync bytes with which it begins
  bool any_talker = false;  ///< sentences: the two characters behind the first may be any letters
  Length length;            ///< binary
  std::optional<Records> records;  ///< binary
  std::string extra;  ///< binary: what its CRC takes in behind the rest, and nobody sends
  std::shared_ptr<const PatternLine> line;  ///< lines: by a pattern; null: by fields in order
  std::uint16_t first_field = 0, fields = 0;
  std::vector<std::uint8_t> mapped;  ///< its fields with a target, by rank
  bool publishes = false;            ///< a field is part of a measurement
  bool divides = false;              ///< a field has a divisor
  bool has_signs = false;            ///< a field is the sign of another one
  bool has_parts = false;            ///< a field is added to another one
  bool emulated = false;             ///< an emulated device sends it with each sample
  /// The message, by its place, that says the same: this one is no measurement while that one
  /// comes.
  std::optional<std::uint16_t> same_as;
  /// Messages of a sample come one behind the other: the place of the one before, and whether
  /// another one comes.
  std::optional<std::uint16_t> follows;
  bool leads = false;

  bool is_alone() const { return !follows && !leads; }
};

struct Plan {
  Form form = Form::sentences;
  Checksum checksum;
  bool checksum_optional = false;            ///< sentences: a line without '*' counts too
  bool decimal_comma = false;                ///< texts: 12,5 is twelve and a half
  bool checksum_big_endian = false;          ///< binary
  std::uint16_t checksum_from = 0;           ///< first byte that it covers
  std::optional<std::uint16_t> checksum_at;  ///< binary: its first byte; empty: behind the fields
  std::optional<HeaderChecksum> header;      ///< binary
  Stuffing stuffing = Stuffing::none;        ///< binary
  std::string end;  ///< binary: bytes behind the checksum, the last of a frame
  std::size_t longest = longest_frame;
  std::array<bool, 256> starts{};  ///< bytes with which a message can begin
  std::vector<Message> messages;
  std::vector<Field> fields;
  FlatTexts texts;  ///< of sentences and lines

  /// Sentences: digits of a checksum behind the '*'.
  std::size_t checksum_digits() const { return 2 * checksum.size(); }

  /// Binary: bytes of a frame behind its fields.
  std::size_t tail() const { return (checksum_at ? 0 : checksum.size()) + end.size(); }

  /// Binary: bytes that every frame has: its checksums and what is in front of what they cover.
  std::size_t least() const {
    const std::size_t sum = checksum_at ? *checksum_at + checksum.size() : 0;
    return std::max<std::size_t>({checksum_from, sum, header ? header->end() : 0}) + tail();
  }

  std::span<const Field> fields_of(const Message& message) const {
    return std::span(fields).subspan(message.first_field, message.fields);
  }
};

}  // namespace drydock::wire::described
