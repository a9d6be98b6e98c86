#include "drivers/monitor/screen_show.hpp"

#include "drivers/monitor/screen/screen.hpp"

namespace drydock::monitor {

ScreenShow::ScreenShow(std::unique_ptr<CursesTerminal> terminal, std::string title, WireSource wire)
    : terminal_(std::move(terminal)), wire_(std::move(wire)) {
  state_.title = std::move(title);
  state_.history = &history_;
  state_.no_wire = wire_.none;
}

void ScreenShow::show(std::vector<DeviceView> views, double now_s) {
  state_.devices = std::move(views);
  state_.now_s = now_s;
  for (const auto& device : state_.devices)
    for (const auto& value : device.values)
      if (!value.numbers.empty()) history_.add(device.name, value.name, {now_s, value.numbers});
  keep_inside(state_);
  if (wire_.show && !state_.devices.empty())
    state_.wire = wire_.show(state_.devices[state_.choice.device]);
  draw();
}

bool ScreenShow::take_keys() {
  bool any = false;
  while (const auto pressed = terminal_->key()) {
    press(state_, pressed->key, pressed->character);
    any = true;
  }
  keep_inside(state_);
  if (any && !state_.devices.empty()) draw();
  return !state_.choice.over;
}

void ScreenShow::draw() {
  terminal_->draw(draw_screen(state_, terminal_->width(), terminal_->height()));
}

}  // namespace drydock::monitor
