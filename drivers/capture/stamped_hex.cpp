#include "drivers/capture/stamped_hex.hpp"

#include <charconv>
#include <optional>
#include <string_view>

#include "drivers/capture/logger_time.hpp"
#include "drivers/capture/sentence_front.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {
namespace {

constexpr std::size_t longest_hex_line = 8192;

std::optional<std::uint8_t> byte_of_pair(std::string_view pair) {
  std::uint8_t byte = 0;
  if (pair.size() != 2) return {};
  const auto [end, error] = std::from_chars(pair.data(), pair.data() + pair.size(), byte, 16);
  return error == std::errc{} && end == pair.data() + pair.size() ? std::optional(byte)
                                                                  : std::nullopt;
}

/// The place of the first of the pairs with which the line ends; its size: it ends with none.
std::size_t pairs_at(std::string_view line) {
  std::size_t at = line.size();
  while (at > 0) {
    const std::size_t end = line.find_last_not_of(' ', at - 1) + 1;
    const std::size_t blank = end == 0 ? line.npos : line.rfind(' ', end - 1);
    const std::size_t begin = blank == line.npos ? 0 : blank + 1;
    if (end == 0 || !byte_of_pair(line.substr(begin, end - begin))) break;
    at = begin;
  }
  return at;
}

bool is_stamped_hex(std::string_view line) {
  const std::size_t at = pairs_at(line);
  return at < line.size() && logger_time(line.substr(0, at)).has_value();
}

std::string_view without_return(std::string_view line) {
  return line.substr(0, line.ends_with('\r') ? line.size() - 1 : line.size());
}

}  // namespace

bool StampedHex::recognises(wire::Bytes bytes) {
  constexpr std::size_t fewest = 3, fewest_pairs = 16;
  std::string_view text = wire::as_text(bytes);
  std::size_t lines = 0, stamped = 0, pairs = 0;
  bool has_letter = false;  // others are numbers of something else
  for (auto end = text.find('\n'); end != text.npos; end = text.find('\n')) {
    const auto line = without_return(text.substr(0, end));
    text.remove_prefix(end + 1);
    if (line.empty()) continue;
    ++lines;
    const bool is_one = is_stamped_hex(line);
    const auto digits = is_one ? line.substr(pairs_at(line)) : std::string_view();
    stamped += is_one;
    pairs += (digits.size() + 1) / 3;
    has_letter = has_letter || digits.find_first_of("ABCDEFabcdef") != digits.npos;
  }
  return stamped >= fewest && 10 * stamped >= 9 * lines && has_letter && pairs >= fewest_pairs;
}

wire::Bytes StampedHex::of(wire::Bytes block) {
  bytes_.clear();
  times_.clear();
  for (const std::uint8_t byte : block) {
    if (byte == '\n')
      take_line();
    else if (line_.size() <= longest_hex_line)
      line_.push_back(byte);
  }
  return bytes_;
}

wire::Bytes StampedHex::finish() {
  constexpr std::uint8_t end[] = {'\n'};
  return of(end);
}

void StampedHex::take_line() {
  const auto line = without_return(wire::as_text(line_));
  const std::size_t at = pairs_at(line);
  const auto stamp = line.substr(0, at);
  const bool known = line.size() <= longest_hex_line && at < line.size();
  if (known && is_of_sent(stamp)) {
    ++sent_;
  } else if (known) {
    ++lines_;
    clock_.take(logger_time(stamp, clock_.order()));
    for (std::size_t i = at; i != line.npos; i = line.find_first_not_of(' ', i + 2))
      bytes_.push_back(*byte_of_pair(line.substr(i, 2)));
    if (clock_.last()) times_.push_back({bytes_.size(), *clock_.last()});
  } else {
    odd_ += !line.empty();
  }
  line_.clear();
}

}  // namespace drydock::capture
