#include "drivers/wire/can/slcan.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "drivers/wire/can/data_length.hpp"
#include "drivers/wire/can/slcan_report.hpp"
#include "drivers/wire/hex.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::wire {

namespace {

using slcan::Answer;
using slcan::Command;
using slcan::Frame;
using slcan::Reply;

constexpr std::uint8_t carriage_return = '\r';
constexpr std::uint8_t bell = '\a';
constexpr std::string_view frame_letters = "tTrRdDbB";
constexpr std::string_view letters_outside_hex = "tTrR";
constexpr std::array<std::uint32_t, 9> bit_rates{10000,  20000,  50000,  100000, 125000,
                                                 250000, 500000, 800000, 1000000};

/// What a frame's letter says.
CanFrame frame_of(char letter) {
  const auto is_one_of = [&](std::string_view letters) { return letters.find(letter) < 4; };
  CanFrame frame;
  frame.extended = is_one_of("TRDB");
  frame.remote = is_one_of("rR");
  frame.fd = is_one_of("dDbB");
  frame.bit_rate_switch = is_one_of("bB");
  return frame;
}

/// Parses the text after the identifier: an optional length digit (some adapters omit it in remote
/// frames), the data, an optional time stamp of four digits.
std::optional<Frame> parse_frame(std::string_view line) {
  Frame message;
  CanFrame& frame = message.frame;
  frame = frame_of(line[0]);
  const std::size_t id_digits = frame.extended ? 8 : 3;
  const auto id = parse_hex(line.substr(1, id_digits));
  if (line.size() < 1 + id_digits || !id || *id > (frame.extended ? 0x1FFFFFFFu : 0x7FFu)) {
    return std::nullopt;
  }
  frame.id = *id;
  std::string_view rest = line.substr(1 + id_digits);

  const bool length_left_out = frame.remote && (rest.empty() || rest.size() == 4);
  if (!length_left_out) {
    const auto length = parse_hex(rest.substr(0, 1));
    if (!length || (*length > 8 && !frame.fd)) return std::nullopt;
    frame.size = fd_sizes[*length];
    rest.remove_prefix(1);
  }
  if (!frame.remote) {
    const std::size_t digits = 2u * frame.size;
    if (rest.size() < digits || !parse_hex_bytes(rest.substr(0, digits), frame.data)) {
      return std::nullopt;
    }
    rest.remove_prefix(digits);
  }
  if (!rest.empty()) {
    const auto time = parse_hex(rest);
    if (rest.size() != 4 || !time) return std::nullopt;
    message.time_ms = static_cast<std::uint16_t>(*time);
  }
  return message;
}

/// Parses commands of the LAWICEL manual and of slcanpty, the adapters' answers to V, v, N and F,
/// and their reports about the bus.
std::optional<Command> parse_command(std::string_view line) {
  const std::string_view argument = line.substr(1);
  const auto hex_of = [&](std::size_t digits) {
    return argument.size() == digits && parse_hex(argument);
  };
  const auto digit_upto = [&](char last) {
    return argument.size() == 1 && argument[0] >= '0' && argument[0] <= last;
  };
  const bool sound = [&] {
    switch (line[0]) {
      case 'S': return digit_upto('8');
      case 'Z': return digit_upto('1');
      case 's': return hex_of(4) || hex_of(6) || slcan::is_report(line);
      case 'e': return slcan::is_report(line);
      case 'O':
      case 'L':
      case 'C': return argument.empty();
      case 'V':
      case 'v': return argument.empty() || hex_of(4);
      case 'F': return argument.empty() || hex_of(2);
      case 'M':
      case 'm': return hex_of(8);
      case 'N':
        return argument.size() <= 4 && std::all_of(argument.begin(), argument.end(), [](char c) {
                 return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
               });
      default: return false;
    }
  }();
  if (!sound) return std::nullopt;
  return Command{line};
}

/// Parses a line without its CR.
std::optional<Slcan::Message> parse_line(std::string_view line) {
  if (line.empty()) return Reply{Answer::done};
  if (line == "z") return Reply{Answer::queued_standard};
  if (line == "Z") return Reply{Answer::queued_extended};
  if (frame_letters.find(line[0]) != std::string_view::npos) {
    if (auto frame = parse_frame(line)) return *frame;
    return std::nullopt;
  }
  if (auto command = parse_command(line)) return *command;
  return std::nullopt;
}

/// Skips a damaged line of `size` bytes including its end, but keeps a frame directly behind it.
Scan give_up(Bytes line) {
  const auto next = std::find_if(line.begin() + 1, line.end(), [](std::uint8_t byte) {
    return letters_outside_hex.find(static_cast<char>(byte)) != std::string_view::npos;
  });
  return {Scan::Kind::bad_checksum, static_cast<std::size_t>(next - line.begin())};
}

}  // namespace

Scan Slcan::scan(Bytes bytes) {
  if (bytes.empty()) return Scan::need_more();
  if (bytes[0] == '\n') return Scan::skip(1);
  if (bytes[0] == bell) return Scan::frame(1);
  const Bytes window = bytes.first(std::min(bytes.size(), max_frame));
  const auto end = std::find_if(window.begin(), window.end(), [](std::uint8_t byte) {
    return byte == carriage_return || byte == bell;
  });
  if (end == window.end()) {
    return window.size() < max_frame ? Scan::need_more() : give_up(window);
  }
  const auto length = static_cast<std::size_t>(end - window.begin());
  if (*end == bell) return give_up(window.first(length));  // refused inside a line: BEL is alone
  if (!parse_line(as_text(window.first(length)))) return give_up(window.first(length + 1));
  return Scan::frame(length + 1);
}

std::optional<Slcan::Message> Slcan::decode(Bytes frame) {
  if (frame.empty()) return std::nullopt;
  if (frame.back() == bell) return Reply{Answer::refused};
  if (frame.back() != carriage_return) return std::nullopt;
  return parse_line(as_text(frame.first(frame.size() - 1)));
}

}  // namespace drydock::wire

namespace drydock::wire::slcan {

std::string_view to_string(Answer answer) {
  constexpr std::array<std::string_view, 4> names{"done", "refused", "queued_standard",
                                                  "queued_extended"};
  return names[static_cast<std::size_t>(answer)];
}

std::size_t encode(const Frame& message, std::span<std::uint8_t> out) {
  const CanFrame& frame = message.frame;
  if (frame.fd || frame.error) return 0;
  TextWriter text(out);
  text.put(frame.extended ? (frame.remote ? 'R' : 'T') : (frame.remote ? 'r' : 't'));
  text.put_hex(frame.id, frame.extended ? 8 : 3);
  text.put_hex(frame.size, 1);
  if (!frame.remote) text.put_hex_bytes(frame.payload());
  if (message.time_ms) text.put_hex(*message.time_ms, 4);
  text.put('\r');
  return text.size();
}

std::size_t encode(const Command& command, std::span<std::uint8_t> out) {
  TextWriter text(out);
  text.put(command.text);
  text.put('\r');
  return text.size();
}

std::size_t encode(const Reply& reply, std::span<std::uint8_t> out) {
  TextWriter text(out);
  switch (reply.answer) {
    case Answer::done: text.put('\r'); break;
    case Answer::refused: text.put('\a'); break;
    case Answer::queued_standard: text.put("z\r"); break;
    case Answer::queued_extended: text.put("Z\r"); break;
  }
  return text.size();
}

std::optional<std::string_view> bit_rate_command(std::uint32_t bits_per_second) {
  constexpr std::string_view commands = "S0S1S2S3S4S5S6S7S8";
  const auto found = std::find(bit_rates.begin(), bit_rates.end(), bits_per_second);
  if (found == bit_rates.end()) return std::nullopt;
  return commands.substr(2 * static_cast<std::size_t>(found - bit_rates.begin()), 2);
}

std::optional<std::uint32_t> bit_rate_of(std::string_view command) {
  if (command.size() != 2 || command[0] != 'S' || command[1] < '0' || command[1] > '8') {
    return std::nullopt;
  }
  return bit_rates[static_cast<std::size_t>(command[1] - '0')];
}

}  // namespace drydock::wire::slcan
