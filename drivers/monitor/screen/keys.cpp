#include "drivers/monitor/screen/keys.hpp"

#include <algorithm>

namespace drydock::monitor {
namespace {

constexpr std::size_t scrolled_lines = 5;

std::size_t items_of(const ScreenState& state) {
  return state.choice.pane == Pane::raw ? chosen_frames(state).size() : chosen_values(state).size();
}

/// The place before or after, around the ends.
std::size_t around(std::size_t at, std::size_t count, bool forward) {
  if (count == 0) return 0;
  return (at + (forward ? 1 : count - 1)) % count;
}

void show_pane(Choice& choice, Pane pane) {
  if ((choice.pane == Pane::raw) != (pane == Pane::raw)) choice.item = 0;
  choice.pane = pane;
  choice.scroll = 0;
}

void choose_device(ScreenState& state, bool forward) {
  state.choice.device = around(state.choice.device, state.devices.size(), forward);
  state.choice.item = state.choice.scroll = 0;
}

void choose_by_letter(Choice& choice, char letter) {
  switch (letter) {
    case 'v': return show_pane(choice, Pane::values);
    case 'p': return show_pane(choice, Pane::plot);
    case 'r': return show_pane(choice, Pane::raw);
    case '/': choice.typing = true; return;
    case 'q': choice.over = true; return;
    default: return;
  }
}

void type(Choice& choice, Key key, char character) {
  if (key == Key::character) choice.filter += character;
  if (key == Key::erase && !choice.filter.empty()) choice.filter.pop_back();
  if (key == Key::escape) choice.filter.clear();
  if (key == Key::enter || key == Key::escape) choice.typing = false;
  choice.item = choice.scroll = 0;
}

}  // namespace

void press(ScreenState& state, Key key, char character) {
  Choice& choice = state.choice;
  const bool moves = key == Key::up || key == Key::down;
  if (choice.typing && !moves) return type(choice, key, character);
  switch (key) {
    case Key::up:
    case Key::down: return choose_device(state, key == Key::down);
    case Key::left:
    case Key::right: choice.item = around(choice.item, items_of(state), key == Key::right); return;
    case Key::page_up: choice.scroll -= std::min(choice.scroll, scrolled_lines); return;
    case Key::page_down: choice.scroll += scrolled_lines; return;
    case Key::tab:
      return show_pane(choice, static_cast<Pane>((static_cast<int>(choice.pane) + 1) % 3));
    case Key::escape: choice.filter.clear(); return;
    case Key::character: return choose_by_letter(choice, character);
    case Key::enter:
    case Key::erase: return;
  }
}

void keep_inside(ScreenState& state) {
  Choice& choice = state.choice;
  choice.device = std::min(choice.device, state.devices.empty() ? 0 : state.devices.size() - 1);
  const auto items = items_of(state);
  choice.item = std::min(choice.item, items == 0 ? 0 : items - 1);
}

}  // namespace drydock::monitor
