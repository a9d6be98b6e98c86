#pragma once

#include <algorithm>
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
    std::string line = fmt::format("{} was told {}", device, what);
    const auto found = std::ranges::find(lines_, line, &Line::text);
    if (found != lines_.end()) return ++found->times, std::string();
    if (lines_.size() == most_lines) return ++more_, std::string();
    lines_.push_back({line, 1});
    return line;
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    for (const auto& line : lines_)
      notes.push_back(line.times > 1 ? fmt::format("{} ({} times)", line.text, line.times)
                                     : line.text);
    if (more_ > 0) notes.push_back(fmt::format("{} more settings of devices were not kept", more_));
    return notes;
  }

 private:
  struct Line {
    std::string text;
    std::size_t times;
  };
  static constexpr std::size_t most_lines = 200;
  std::vector<Line> lines_;
  std::size_t more_ = 0;
};

}  // namespace drydock::bench
