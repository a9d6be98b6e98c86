#include "drivers/capture/formats/crtd.hpp"

#include "drivers/capture/words.hpp"

namespace drydock::capture {
namespace {

constexpr int seconds_of_ns = 9;

struct Line {
  std::chrono::nanoseconds at{};
  std::uint32_t bus = 1;
  bool remark = false;
  wire::CanFrame frame;
};

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

bool read_frame(Words& words, Line& line) {
  const auto id = parse_number(words.next(), 16);
  if (!id || *id > (line.frame.extended ? 0x1FFFFFFFu : 0x7FFu)) return false;
  line.frame.id = *id;
  std::uint8_t size = 0;
  for (; !words.peek().empty(); ++size) {
    const auto word = words.next();
    const auto byte = parse_number(word, 16);
    if (!byte || word.size() != 2 || size == 8) return false;
    line.frame.data.at(size) = static_cast<std::uint8_t>(*byte);
  }
  line.frame.size = size;
  return true;
}

std::optional<Line> parse(std::string_view text) {
  Words words(text);
  Line line;
  const auto stamp = words.next();
  const auto at = parse_time(stamp, seconds_of_ns);
  std::string_view type = words.next();
  if (!at || stamp.find('.') == stamp.npos || type.size() < 3) return std::nullopt;
  line.at = *at;
  if (is_digit(type[0])) {
    line.bus = static_cast<std::uint32_t>(type[0] - '0');
    type.remove_prefix(1);
  }
  line.remark = type.size() == 3 && type[0] == 'C' && type[1] >= 'A' && type[1] <= 'Z';
  line.frame.extended = type == "R29" || type == "T29";
  const bool frame = line.frame.extended || type == "R11" || type == "T11";
  if (line.remark) return line;
  return frame && line.bus > 0 && read_frame(words, line) ? std::optional(line) : std::nullopt;
}

}  // namespace

bool Crtd::recognises(std::string_view text) { return parse(text).has_value(); }

Reading Crtd::read_line(std::string_view text) {
  const auto line = parse(text);
  if (!line) return Reading::damage();
  if (line->remark) return Reading::nothing();
  interface_ = "can" + std::to_string(line->bus - 1);
  return {Record{line->at, interface_, line->frame}, false};
}

}  // namespace drydock::capture
