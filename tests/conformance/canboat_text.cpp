#include "tests/conformance/canboat_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <vector>

#include "tests/conformance/reading.hpp"

namespace drydock::conformance {

namespace {

struct Message {
  std::uint32_t priority = 0, pgn = 0, source = 0, destination = 0;
  std::vector<std::uint8_t> data;
};

std::optional<std::uint32_t> number(std::string_view text, int base) {
  std::uint32_t value = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value, base).ptr;
  if (text.empty() || end != text.data() + text.size()) return {};
  return value;
}

std::optional<Message> read_plain(std::string_view line) {
  const auto parts = split(line, ',');
  if (parts.size() < 7) return {};
  const auto priority = number(parts[1], 10), pgn = number(parts[2], 10),
             source = number(parts[3], 10), destination = number(parts[4], 10),
             size = number(parts[5], 10);
  if (!priority || !pgn || !source || !destination || !size) return {};
  Message message{*priority, *pgn, *source, *destination, {}};
  for (std::size_t i = 6; i < parts.size() && message.data.size() < *size; ++i)
    if (const auto byte = number(std::string_view(parts[i]).substr(0, 2), 16))
      message.data.push_back(static_cast<std::uint8_t>(*byte));
  return message;
}

std::optional<Message> read_actisense(std::string_view line) {
  const auto parts = split(line, ' ');
  if (parts.size() < 4 || !parts[0].starts_with('A') || parts[1].size() != 5) return {};
  const auto addresses = number(parts[1], 16), pgn = number(parts[2], 16);
  if (!addresses || !pgn) return {};
  Message message{*addresses & 0xF, *pgn, *addresses >> 12, *addresses >> 4 & 0xFF, {}};
  for (std::size_t i = 0; i + 1 < parts[3].size(); i += 2)
    if (const auto byte = number(std::string_view(parts[3]).substr(i, 2), 16))
      message.data.push_back(static_cast<std::uint8_t>(*byte));
  return message;
}

std::uint32_t identifier(const Message& m) {
  const bool addressed = (m.pgn >> 8 & 0xFF) < 240;
  return m.priority << 26 | (addressed ? m.pgn | m.destination : m.pgn) << 8 | m.source;
}

void write_frame(std::uint32_t id, const std::vector<std::uint8_t>& data, std::string& out) {
  out += fmt::format("(0.000000) can0 {:08X}#", id);
  for (const std::uint8_t byte : data) out += fmt::format("{:02X}", byte);
  out += '\n';
}

/// Frame 0: counter, length, 6 bytes; frame n: counter, 7 bytes.
void write_fast_packet(const Message& m, unsigned sequence, std::string& out) {
  std::size_t at = 0;
  for (unsigned n = 0; at < m.data.size(); ++n) {
    std::vector<std::uint8_t> frame{static_cast<std::uint8_t>(sequence << 5 | n)};
    if (n == 0) frame.push_back(static_cast<std::uint8_t>(m.data.size()));
    while (frame.size() < 8) frame.push_back(at < m.data.size() ? m.data[at] : 0xFF), ++at;
    write_frame(identifier(m), frame, out);
  }
}

}  // namespace

std::string candump_of(std::string_view text) {
  std::string out;
  unsigned sequence = 0;
  for (const std::string& line : lines_of(text)) {
    auto message = read_plain(line);
    if (!message) message = read_actisense(line);
    if (!message) continue;
    if (message->data.size() <= 8)
      write_frame(identifier(*message), message->data, out);
    else
      write_fast_packet(*message, sequence++ & 7, out);
  }
  return out;
}

}  // namespace drydock::conformance
