#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "drivers/monitor/curses_terminal.hpp"
#include "drivers/monitor/screen/screen_state.hpp"

namespace drydock::monitor {

/// Where the bytes of a device come from.
struct WireSource {
  std::function<ShownWire(const DeviceView&)> show;
  std::string none{};  ///< why there are no bytes, in words; empty: there may be
};

/// The screen of a monitor on a terminal: new views twice a second, keys at once.
class ScreenShow {
 public:
  ScreenShow(std::unique_ptr<CursesTerminal> terminal, std::string title, WireSource wire);

  void show(std::vector<DeviceView> views, double now_s);
  bool take_keys();  ///< false: the person wants to leave
  Choice& choice() { return state_.choice; }

 private:
  void draw();

  std::unique_ptr<CursesTerminal> terminal_;
  WireSource wire_;
  History history_;
  ScreenState state_;
};

}  // namespace drydock::monitor
