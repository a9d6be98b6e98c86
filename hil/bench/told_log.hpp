#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace drydock::bench {

/// What hosts have told the emulated devices: each line once, with its number.
class ToldLog {
 public:
  /// Returns the line for a person. Empty: it was told before.
  std::string add(std::string_view device, std::string_view what) {
    ++told_;
    const auto found = std::ranges::find_if(
        lines_, [&](const Line& line) { return line.device == device && line.what == what; });
    if (found != lines_.end()) {
      ++found->times;
      found->last = told_;
      return {};
    }
    if (lines_.size() == most_lines) return ++more_, std::string();
    return lines_.emplace_back(Line{std::string(device), std::string(what), 1, told_}).text();
  }

  /// What one device was told, each once, in one line: the last at the end. Of many the last ones.
  std::string latest(std::string_view device) const {
    std::vector<const Line*> lines;
    for (const Line& line : lines_)
      if (line.device == device) lines.push_back(&line);
    std::ranges::sort(lines, {}, &Line::last);
    const std::size_t left_out = lines.size() > most_in_a_line ? lines.size() - most_in_a_line : 0;
    std::string text = left_out > 0 ? fmt::format("({} before)", left_out) : std::string();
    for (std::size_t i = left_out; i < lines.size(); ++i)
      text += (text.empty() ? "" : "; ") + lines[i]->what;
    return text;
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    for (const auto& line : lines_)
      notes.push_back(line.times > 1 ? fmt::format("{} ({} times)", line.text(), line.times)
                                     : line.text());
    if (more_ > 0) notes.push_back(fmt::format("{} more settings of devices were not kept", more_));
    return notes;
  }

 private:
  struct Line {
    std::string text() const { return fmt::format("{} was told {}", device, what); }

    std::string device, what;
    std::size_t times;
    std::uint64_t last;  ///< its place among all that was told
  };
  static constexpr std::size_t most_lines = 200, most_in_a_line = 16;
  std::vector<Line> lines_;
  std::uint64_t told_ = 0;
  std::size_t more_ = 0;
};

}  // namespace drydock::bench
