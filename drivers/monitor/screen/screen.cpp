#include "drivers/monitor/screen/screen.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/monitor/screen/device_lines.hpp"
#include "drivers/monitor/screen/panes.hpp"
#include "drivers/monitor/values/display_units.hpp"

namespace drydock::monitor {
namespace {

constexpr std::size_t fixed_rows = 4;     // title, heads, rule, keys
constexpr std::size_t pane_at_least = 4;  // where there are more devices than rows

constexpr std::string_view pane_names[] = {"values", "plot", "raw"};

void draw_title(Canvas& canvas, const ScreenState& state) {
  const auto streaming = std::ranges::count(state.devices, true, &DeviceView::streaming);
  canvas.put(0, 1,
             fmt::format("{}  {} UTC  {} of {} streaming", state.title, clock_text(state.now_s, 0),
                         streaming, state.devices.size()),
             Style::title);
  canvas.fill(0, Style::title);
}

void draw_rule(Canvas& canvas, const ScreenState& state, std::size_t row, std::size_t hidden) {
  for (std::size_t i = 0; i < canvas.width(); ++i) canvas.put(row, i, "-", Style::dim);
  std::string text = fmt::format(" {}: {} ", state.devices[state.choice.device].name,
                                 pane_names[static_cast<std::size_t>(state.choice.pane)]);
  if (!state.choice.filter.empty() || state.choice.typing)
    text += fmt::format("filter /{}{} ", state.choice.filter, state.choice.typing ? "_" : "");
  if (hidden > 0) text += fmt::format("{} devices more: arrows ", hidden);
  canvas.put(row, 2, text, Style::heading);
}

std::vector<PaneLine> lines_of_pane(const ScreenState& state, std::size_t width,
                                    std::size_t height) {
  switch (state.choice.pane) {
    case Pane::plot: return plot_pane(state, width, height);
    case Pane::raw: return raw_pane(state, width, height);
    case Pane::values: break;
  }
  return values_pane(state, width);
}

/// Draws the lines from the scrolled place on. The last row says how many are below it.
void draw_pane(Canvas& canvas, const ScreenState& state, std::size_t row, std::size_t height) {
  const auto lines = lines_of_pane(state, canvas.width() - 1, height);
  const std::size_t past = lines.size() > height ? lines.size() - height : 0;
  const std::size_t first = std::min(state.choice.scroll, past);
  for (std::size_t i = 0; i < height && first + i < lines.size(); ++i) {
    std::size_t column = 0;
    for (const auto& span : lines[first + i])
      column = canvas.put(row + i, column, span.text, span.style);
  }
  const std::size_t below = lines.size() - first - std::min(height, lines.size() - first);
  if (below == 0) return;
  const std::string more = fmt::format(" {} more: PgDn ", below + 1);
  const std::size_t last = row + height - 1;
  for (std::size_t i = 0; i < canvas.width(); ++i) canvas.put(last, i, " ");
  canvas.put(last, 0, more, Style::heading);
}

void draw_keys(Canvas& canvas, const ScreenState& state) {
  const std::string_view keys = state.choice.typing
                                    ? "type a text; Enter keeps it, Esc removes it"
                                    : "Up Dn device  Tab v p r pane  Lt Rt item  / filter  q quit";
  canvas.put(canvas.height() - 1, 0, keys, Style::dim);
}

}  // namespace

Canvas draw_screen(const ScreenState& state, std::size_t width, std::size_t height) {
  Canvas canvas(width, height);
  if (height == 0 || width == 0) return canvas;
  draw_title(canvas, state);
  if (state.devices.empty()) return canvas;
  const std::size_t room = height > fixed_rows + 1 ? height - fixed_rows : 1;
  const std::size_t most =
      std::max<std::size_t>(1, room > pane_at_least ? room - pane_at_least : 1);
  std::size_t row = draw_devices(canvas, state, 1, most);
  const std::size_t shown = std::min(most, state.devices.size());
  if (row + 1 >= height) return canvas;
  draw_rule(canvas, state, row++, state.devices.size() - shown);
  if (row + 1 < height) draw_pane(canvas, state, row, height - 1 - row);
  draw_keys(canvas, state);
  return canvas;
}

}  // namespace drydock::monitor
