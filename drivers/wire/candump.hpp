#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "drivers/wire/can_frame.hpp"
#include "drivers/wire/codec.hpp"

/// Log lines of can-utils' `candump -L` and `-l`: `(1436509052.249713) vcan0 044#2A366C2BBA`.
/// 3 hex digits are an 11-bit, 8 a 29-bit identifier or, with 0x20000000, an error frame;
/// `#R4` a remote frame, `##1...` CAN FD with its flags; ` R` or ` T` may follow.
namespace drydock::wire::candump {

enum class Direction : std::uint8_t { unknown, received, transmitted };

std::string_view to_string(Direction direction);

struct Line {
  static constexpr std::string_view type = "can_frame";
  std::chrono::nanoseconds time{};  ///< UTC since 1970 in most logs, in some since the start
  std::string_view interface;       ///< points into the bytes given to decode
  CanFrame frame;
  Direction direction = Direction::unknown;
};

/// Writes the line with its LF as `candump -L` does, microseconds; returns its size.
std::size_t encode(const Line& line, std::span<std::uint8_t> out);

/// Upper-case hex of a frame's data.
class HexText {
 public:
  explicit HexText(Bytes bytes);
  std::string_view view() const { return {text_.data(), size_}; }

 private:
  std::array<char, 128> text_{};
  std::size_t size_ = 0;
};

template <class Field>
void visit_fields(const Line& m, Field&& field) {
  field("time_ns", static_cast<std::int64_t>(m.time.count()));
  field("interface", m.interface);
  field("id", m.frame.id);
  field("extended", m.frame.extended);
  field("remote", m.frame.remote);
  field("error", m.frame.error);
  field("fd", m.frame.fd);
  field("size", m.frame.size);
  field("data", HexText(m.frame.payload()).view());
  field("direction", to_string(m.direction));
}

}  // namespace drydock::wire::candump

namespace drydock::wire {

/// A byte protocol of lines ended by LF or CR. The sync is "(": a damaged line is given up one byte
/// past it, so a good line glued behind a torn one is found.
struct Candump {
  static constexpr std::string_view name = "candump";
  static constexpr std::size_t max_frame = 288;
  using Message = std::variant<candump::Line>;

  static Scan scan(Bytes bytes);
  static std::optional<Message> decode(Bytes frame);
};

}  // namespace drydock::wire
