#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "drivers/monitor/screen/panes.hpp"

namespace drydock::monitor {
namespace {

constexpr std::size_t axis_width = 13;
constexpr std::array<char, 4> component_marks{'x', 'y', 'z', 'w'};

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void take(double number) {
    if (!std::isfinite(number)) return;
    low = std::min(low, number);
    high = std::max(high, number);
  }
  bool empty() const { return low > high; }
  /// A value that does not change lies in the middle.
  void widen() {
    if (high > low) return;
    const double half = std::max(1e-3, 1e-3 * std::abs(low));
    low -= half;
    high += half;
  }
};

class PlotGrid {
 public:
  PlotGrid(std::size_t width, std::size_t height, Extent values, double from_s, double to_s)
      : rows_(height, std::string(width, ' ')), values_(values), from_s_(from_s), to_s_(to_s) {}

  void put(double at_s, double number, char mark) {
    if (!std::isfinite(number) || at_s < from_s_) return;
    const double across = (at_s - from_s_) / (to_s_ - from_s_);
    const double up = (number - values_.low) / (values_.high - values_.low);
    row(1 - up)[place(across, rows_[0].size())] = mark;
  }
  const std::vector<std::string>& rows() const { return rows_; }

 private:
  static std::size_t place(double part, std::size_t count) {
    return static_cast<std::size_t>(
        std::lround(std::clamp(part, 0.0, 1.0) * static_cast<double>(count - 1)));
  }
  std::string& row(double down) { return rows_[place(down, rows_.size())]; }

  std::vector<std::string> rows_;
  Extent values_;
  double from_s_, to_s_;
};

std::string axis_label(std::size_t row, std::size_t rows, const Extent& e) {
  const std::size_t middle = rows / 2;
  if (row != 0 && row != middle && row + 1 != rows) return std::string(axis_width - 1, ' ') + '|';
  const double part =
      static_cast<double>(row) / static_cast<double>(std::max<std::size_t>(rows - 1, 1));
  return fmt::format("{:>11.7g} |", e.high - part * (e.high - e.low));
}

Extent extent_of(const std::deque<Sampled>& samples) {
  Extent extent;
  for (const auto& sample : samples)
    for (const double number : sample.numbers) extent.take(number);
  return extent;
}

/// The chosen value, or the next one that is a number.
const ShownValue& plotted(const std::vector<const ShownValue*>& values, std::size_t chosen) {
  const auto from =
      values.begin() + static_cast<std::ptrdiff_t>(std::min(chosen, values.size() - 1));
  const auto number =
      std::find_if(from, values.end(), [](const ShownValue* v) { return !v->numbers.empty(); });
  return number == values.end() ? **from : **number;
}

std::string head_of(const ShownValue& value, double shown_s) {
  std::string text = fmt::format("{} {}, last {:.0f} s", value.name, value.full(), shown_s);
  return value.numbers.size() > 1 ? text + ": first x, then y, z" : text;
}

}  // namespace

std::vector<PaneLine> plot_pane(const ScreenState& state, std::size_t width, std::size_t height) {
  const auto values = chosen_values(state);
  if (values.empty() || state.history == nullptr) return {{{"nothing to plot"}}};
  const ShownValue& value = plotted(values, state.choice.item);
  const auto& samples = state.history->of(state.devices[state.choice.device].name, value.name);
  Extent extent = extent_of(samples);
  if (extent.empty() || height < 5 || width < axis_width + 10)
    return {{{value.name + ' ' + value.full() + ": nothing to plot"}}};
  extent.widen();
  const double shown_s = std::clamp(state.now_s - samples.front().at_s, 10.0, History::kept_s);
  PlotGrid grid(width - axis_width, height - 2, extent, state.now_s - shown_s, state.now_s);
  for (const auto& sample : samples)
    for (std::size_t i = 0; i < sample.numbers.size(); ++i)
      grid.put(sample.at_s, sample.numbers[i],
               value.numbers.size() > 1 ? component_marks[i % component_marks.size()] : '*');
  std::vector<PaneLine> lines{{{head_of(value, shown_s), Style::heading}}};
  for (std::size_t row = 0; row < grid.rows().size(); ++row)
    lines.push_back(
        {{axis_label(row, grid.rows().size(), extent), Style::dim}, {grid.rows()[row]}});
  const std::string begin = fmt::format("{:.0f} s ago", shown_s);
  lines.push_back(
      {{std::string(axis_width, ' ') + padded(begin, width - axis_width - 3) + "now", Style::dim}});
  return lines;
}

}  // namespace drydock::monitor
