#include "drivers/wire/can/slcan_report.hpp"

#include <algorithm>
#include <array>

namespace drydock::wire::slcan {

namespace {

// linux/can/error.h
constexpr std::uint32_t controller = 0x004, protocol = 0x008, no_acknowledge = 0x020,
                        bus_off = 0x040, restarted = 0x100;
constexpr std::size_t of_controller = 1, of_protocol = 2, of_place = 3;
constexpr std::uint8_t crc_sequence = 0x08;

/// A letter of an `e` line: its error class, the byte with details, and the value of that byte.
struct Kind {
  char letter;
  std::uint32_t error_class;
  std::size_t byte;
  std::uint8_t bits;
};

constexpr std::array<Kind, 8> kinds{{{'b', protocol, of_protocol, 0x08},
                                     {'B', protocol, of_protocol, 0x10},
                                     {'f', protocol, of_protocol, 0x02},
                                     {'s', protocol, of_protocol, 0x04},
                                     {'c', protocol, of_place, crc_sequence},
                                     {'a', no_acknowledge, of_protocol, 0},
                                     {'o', controller, of_controller, 0x01},
                                     {'O', controller, of_controller, 0x02}}};

constexpr std::uint8_t warning = 0x0C, passive = 0x30;

const Kind* find_kind(char letter) {
  const auto* found = std::ranges::find(kinds, letter, &Kind::letter);
  return found == kinds.end() ? nullptr : found;
}

bool is_state(std::string_view line) {
  constexpr std::size_t size = 8;
  return line.size() == size && line[0] == 's' &&
         std::string_view("awpb").find(line[1]) != std::string_view::npos &&
         std::ranges::all_of(line.substr(2), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_errors(std::string_view line) {
  return line.size() > 2 && line[0] == 'e' && line[1] >= '1' && line[1] <= '9' &&
         line.size() == 2u + static_cast<unsigned>(line[1] - '0') &&
         std::ranges::all_of(line.substr(2), [](char c) { return find_kind(c) != nullptr; });
}

CanFrame empty_error() {
  CanFrame frame;
  frame.error = true;
  frame.size = 8;
  return frame;
}

}  // namespace

bool is_report(std::string_view line) { return is_state(line) || is_errors(line); }

std::string report_of(const CanFrame& frame) {
  if (frame.id & bus_off) return "sb256256\r";
  if (frame.id & restarted) return "sa000000\r";
  if (frame.id & controller && frame.data[of_controller] & passive) return "sp128128\r";
  if (frame.id & controller && frame.data[of_controller] & warning) return "sw096096\r";
  std::string letters;
  for (const Kind& kind : kinds) {
    const bool told = kind.bits == 0 || (frame.data.at(kind.byte) & kind.bits) == kind.bits;
    if ((frame.id & kind.error_class) && told) letters += kind.letter;
  }
  if (letters.empty() && (frame.id & protocol)) letters = "b";  // a bit error of unknown kind
  return letters.empty() ? letters : "e" + std::to_string(letters.size()) + letters + "\r";
}

std::optional<CanFrame> error_frame_of(std::string_view line) {
  CanFrame frame = empty_error();
  if (is_state(line)) {
    switch (line[1]) {
      case 'b': frame.id = bus_off; break;
      case 'a': frame.id = restarted; break;
      default:
        frame.id = controller;
        frame.data[of_controller] = line[1] == 'p' ? passive : warning;
    }
    return frame;
  }
  if (!is_errors(line)) return std::nullopt;
  for (const char letter : line.substr(2)) {
    const Kind& kind = *find_kind(letter);
    frame.id |= kind.error_class;
    frame.data.at(kind.byte) |= kind.bits;
  }
  return frame;
}

}  // namespace drydock::wire::slcan
