#include "drivers/wire/can/gateway_line.hpp"

#include <algorithm>

#include "drivers/wire/hex.hpp"

namespace drydock::wire::gateway_line {
namespace {

void put_frame(const CanFrame& frame, TextWriter& line) {
  line.put_hex(frame.id, 8);
  for (const std::uint8_t byte : frame.payload()) {
    line.put(' ');
    line.put_hex(byte, 2);
  }
  line.put("\r\n");
}

std::string_view next_word(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  const std::string_view word = rest.substr(0, rest.find(' '));
  rest.remove_prefix(word.size());
  return word;
}

}  // namespace

bool carries(const CanFrame& frame) {
  return frame.extended && !frame.remote && !frame.error && !frame.fd && frame.size <= 8;
}

std::size_t encode(const CanFrame& frame, std::chrono::nanoseconds since_midnight, Way way,
                   std::span<std::uint8_t> out) {
  if (!carries(frame)) return 0;
  using namespace std::chrono;
  const hh_mm_ss clock(duration_cast<milliseconds>(since_midnight));
  TextWriter line(out);
  line.put_decimal(static_cast<std::uint64_t>(clock.hours().count()), 2);
  line.put(':');
  line.put_decimal(static_cast<std::uint64_t>(clock.minutes().count()), 2);
  line.put(':');
  line.put_decimal(static_cast<std::uint64_t>(clock.seconds().count()), 2);
  line.put('.');
  line.put_decimal(static_cast<std::uint64_t>(clock.subseconds().count()), 3);
  line.put(' ');
  line.put(static_cast<char>(way));
  line.put(' ');
  put_frame(frame, line);
  return line.size();
}

std::size_t encode_order(const CanFrame& frame, std::span<std::uint8_t> out) {
  if (!carries(frame)) return 0;
  TextWriter line(out);
  put_frame(frame, line);
  return line.size();
}

std::optional<CanFrame> parse_order(std::string_view line) {
  const std::string_view identifier = next_word(line);
  const auto id = parse_hex(identifier);
  if (identifier.size() != 8 || !id || *id > 0x1FFF'FFFF) return std::nullopt;
  CanFrame frame{.id = *id, .extended = true};
  for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
    const auto byte = parse_hex(word);
    if (word.size() != 2 || !byte || frame.size == 8) return std::nullopt;
    frame.data[frame.size++] = static_cast<std::uint8_t>(*byte);
  }
  return frame;
}

}  // namespace drydock::wire::gateway_line
