#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/codec.hpp"

/// The serial line protocol of LAWICEL adapters ("slcan"): ASCII lines that end with CR.
/// `t1233AABBCC` is an 11-bit data frame, `T` 29-bit, `r` `R` remote; adapters for CAN FD add `d`
/// `D` and, at two rates, `b` `B`. S0..S8 bit rate, O open, L listen only, C close; V v N F ask for
/// version, serial number, status; Z0 Z1 time stamps off, on. The adapter answers CR (done), BEL
/// (refused), `z` CR and `Z` CR (frame queued).
namespace drydock::wire::slcan {

/// A CAN frame on the line, in either direction. `time_ms` counts modulo 60000.
struct Frame {
  static constexpr std::string_view type = "can_frame";
  CanFrame frame;
  std::optional<std::uint16_t> time_ms;
};

/// Any other line: a command with its argument, or the adapter's answer to a question, which has
/// the same form (`V1013`). Both point into the bytes that decode received.
struct Command {
  static constexpr std::string_view type = "command";
  std::string_view text;  ///< letter and argument without the CR
  char letter() const { return text.front(); }
  std::string_view argument() const { return text.substr(1); }
};

enum class Answer : std::uint8_t { done, refused, queued_standard, queued_extended };

struct Reply {
  static constexpr std::string_view type = "reply";
  Answer answer = Answer::done;
};

std::string_view to_string(Answer answer);

/// Each writes one line and returns its size. CAN FD frames, which few adapters know, and error
/// frames are not written: size 0.
std::size_t encode(const Frame& frame, std::span<std::uint8_t> out);
std::size_t encode(const Command& command, std::span<std::uint8_t> out);
std::size_t encode(const Reply& reply, std::span<std::uint8_t> out);

/// "S5" for 250000. Empty if the adapters have no command for the rate.
std::optional<std::string_view> bit_rate_command(std::uint32_t bits_per_second);
std::optional<std::uint32_t> bit_rate_of(std::string_view command);

template <class Field>
void visit_fields(const Frame& m, Field&& field) {
  field("id", m.frame.id);
  field("extended", m.frame.extended);
  field("remote", m.frame.remote);
  field("size", m.frame.size);
  field("time_ms", m.time_ms);
}

template <class Field>
void visit_fields(const Command& m, Field&& field) {
  field("text", m.text);
}

template <class Field>
void visit_fields(const Reply& m, Field&& field) {
  field("answer", to_string(m.answer));
}

}  // namespace drydock::wire::slcan

namespace drydock::wire {

/// A byte protocol. A damaged line is skipped up to the next frame letter (t T r R never occur in a
/// hex field), otherwise to its end. The reason: its tail may look like a command ("...C" CR would
/// close the channel).
struct Slcan {
  static constexpr std::string_view name = "slcan";
  static constexpr std::size_t max_frame = 144;  ///< a CAN FD frame with a time stamp
  using Message = std::variant<slcan::Frame, slcan::Command, slcan::Reply>;

  static Scan scan(Bytes bytes);
  static std::optional<Message> decode(Bytes frame);
};

}  // namespace drydock::wire
