#pragma once

#include <memory>
#include <optional>

#include "drivers/monitor/screen/canvas.hpp"
#include "drivers/monitor/screen/keys.hpp"

namespace drydock::monitor {

struct KeyPress {
  Key key = Key::character;
  char character = 0;
};

/// The terminal of this process while one of these lives: it shows canvases and gives keys. Ctrl-C
/// stays a signal. The destructor puts the terminal back as it was.
class CursesTerminal {
 public:
  /// Null if standard output is no terminal, or one that cannot place its cursor (TERM=dumb).
  static std::unique_ptr<CursesTerminal> open();
  ~CursesTerminal();
  CursesTerminal(const CursesTerminal&) = delete;
  CursesTerminal& operator=(const CursesTerminal&) = delete;

  std::size_t width() const;   ///< columns; follows the window
  std::size_t height() const;  ///< rows
  void draw(const Canvas& canvas);
  std::optional<KeyPress> key();  ///< does not wait; empty: nothing was pressed

 private:
  explicit CursesTerminal(void* screen);
  void* screen_;
  bool unicode_, colours_;
};

}  // namespace drydock::monitor
