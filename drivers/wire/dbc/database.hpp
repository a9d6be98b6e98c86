#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// What a DBC file says: messages, their signals, and the texts around them. All texts are UTF-8.
namespace drydock::wire::dbc {

constexpr std::size_t most_signals = 1024;  ///< of one message
constexpr std::size_t most_bytes = 4095;    ///< of one message: more than any transport carries
constexpr std::uint8_t any_source = 0xFE;   ///< J1939: this address in a file stands for any

/// A place in the text, counted from 1; columns count characters.
struct Place {
  unsigned line = 1, column = 1;
  friend bool operator==(const Place&, const Place&) = default;
};

struct Remark {
  Place at;
  std::string text;
};

/// Bit numbers are byte * 8 + weight. Intel: `start` is the lowest bit. Motorola: the highest.
enum class ByteOrder : std::uint8_t { intel, motorola };

enum class Number : std::uint8_t { unsigned_integer, signed_integer, float32, float64 };

struct Layout {
  unsigned start = 0, bits = 1;  ///< bits: 1 to 64
  ByteOrder order = ByteOrder::intel;
  Number number = Number::unsigned_integer;
  double factor = 1, offset = 0;  ///< physical = raw * factor + offset

  /// Bytes that a frame must have for this signal.
  unsigned bytes_needed() const {
    const unsigned first = order == ByteOrder::intel ? start : start / 8 * 8 + 7 - start % 8;
    return (first + bits + 7) / 8;
  }
  bool is_float() const { return number == Number::float32 || number == Number::float64; }
};

/// Raw values from first to last.
struct Range {
  std::int64_t first = 0, last = 0;
  bool has(std::int64_t value) const { return first <= value && value <= last; }
  friend bool operator==(const Range&, const Range&) = default;
};

struct Label {
  std::int64_t raw = 0;
  std::string text;
};

struct Signal {
  std::string name;       ///< at most 32 characters, unique in its message
  std::string long_name;  ///< the one meant; mostly the same
  Place at;
  Layout layout;
  double lowest = 0, highest = 0;  ///< physical; both 0: not limited
  std::string unit, comment;
  std::vector<Label> labels;
  bool selector = false;
  std::optional<std::size_t> selected_by;  ///< place of a selector in Message::signals, before this
  std::vector<Range> when;                 ///< raw values of that selector

  const std::string* label_of(std::int64_t raw) const {
    for (const Label& label : labels)
      if (label.raw == raw) return &label.text;
    return nullptr;
  }
};

enum class FrameFormat : std::uint8_t { classic, fd, j1939 };

struct Message {
  std::uint32_t id = 0;  ///< 11 or 29 bits
  bool extended = false;
  FrameFormat format = FrameFormat::classic;
  std::string name, long_name, comment;
  Place at;
  unsigned size = 0;  ///< bytes
  std::vector<std::string> senders;
  unsigned cycle_ms = 0;        ///< 0: not cyclic
  std::vector<Signal> signals;  ///< in the file's order, but selectors before what they select

  const Signal* find(std::string_view signal) const {
    for (const Signal& s : signals)
      if (s.name == signal || s.long_name == signal) return &s;
    return nullptr;
  }
};

struct Node {
  std::string name, long_name, comment;
};

struct Database {
  std::vector<Message> messages;
  std::vector<Node> nodes;

  const Message* find(std::string_view message) const {
    for (const Message& m : messages)
      if (m.name == message || m.long_name == message) return &m;
    return nullptr;
  }
};

}  // namespace drydock::wire::dbc
