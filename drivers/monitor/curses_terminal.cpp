#include "drivers/monitor/curses_terminal.hpp"

#define NCURSES_NOMACROS 1
#define NCURSES_WIDECHAR 1
#include <curses.h>
#include <langinfo.h>

#include <array>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "drivers/monitor/places_cursor.hpp"

namespace drydock::monitor {
namespace {

constexpr int escape_wait_ms = 25;  // an arrow key is an escape and letters; over ssh they part

bool colours_wanted() {
  const char* none = std::getenv("NO_COLOR");
  return has_colors() && (none == nullptr || *none == '\0');
}

void choose_colours() {
  start_color();
  use_default_colors();
  init_pair(1, COLOR_GREEN, -1);
  init_pair(2, COLOR_YELLOW, -1);
  init_pair(3, COLOR_RED, -1);
  init_pair(4, COLOR_CYAN, -1);
}

struct Look {
  attr_t attributes;
  short pair;
};

Look look_of(Style style, bool colours) {
  const auto coloured = [&](short pair, attr_t otherwise) {
    return colours ? Look{A_NORMAL, pair} : Look{otherwise, 0};
  };
  switch (style) {
    case Style::title: return {A_REVERSE, 0};
    case Style::heading: return {A_BOLD, 0};
    case Style::good: return coloured(1, A_NORMAL);
    case Style::waiting: return coloured(2, A_BOLD);
    case Style::wrong: return coloured(3, A_BOLD);
    case Style::changed: return {A_REVERSE, 0};
    case Style::chosen: return {A_BOLD | A_REVERSE, 0};
    case Style::dim: return coloured(4, A_NORMAL);
    case Style::plain: break;
  }
  return {A_NORMAL, 0};
}

std::optional<KeyPress> key_press(int code) {
  switch (code) {
    case KEY_UP: return KeyPress{Key::up};
    case KEY_DOWN: return KeyPress{Key::down};
    case KEY_LEFT: return KeyPress{Key::left};
    case KEY_RIGHT: return KeyPress{Key::right};
    case KEY_PPAGE: return KeyPress{Key::page_up};
    case KEY_NPAGE: return KeyPress{Key::page_down};
    case '\t': return KeyPress{Key::tab};
    case '\r':
    case '\n':
    case KEY_ENTER: return KeyPress{Key::enter};
    case 0x1B: return KeyPress{Key::escape};
    case 0x7F:
    case '\b':
    case KEY_BACKSPACE: return KeyPress{Key::erase};
    default: break;
  }
  if (code >= 0x20 && code < 0x7F) return KeyPress{Key::character, static_cast<char>(code)};
  return std::nullopt;
}

}  // namespace

std::unique_ptr<CursesTerminal> CursesTerminal::open() {
  if (!places_cursor()) return nullptr;
  std::setlocale(LC_CTYPE, "");  // numbers keep their point
  SCREEN* screen = newterm(nullptr, stdout, stdin);
  if (screen == nullptr) return nullptr;
  return std::unique_ptr<CursesTerminal>(new CursesTerminal(screen));
}

CursesTerminal::CursesTerminal(void* screen)
    : screen_(screen),
      unicode_(std::strcmp(nl_langinfo(CODESET), "UTF-8") == 0),
      colours_(colours_wanted()) {
  if (colours_) choose_colours();
  cbreak();
  noecho();
  nonl();
  curs_set(0);
  set_escdelay(escape_wait_ms);
  keypad(stdscr, TRUE);
  nodelay(stdscr, TRUE);
}

CursesTerminal::~CursesTerminal() {
  endwin();
  delscreen(static_cast<SCREEN*>(screen_));
}

std::size_t CursesTerminal::width() const { return static_cast<std::size_t>(getmaxx(stdscr)); }
std::size_t CursesTerminal::height() const { return static_cast<std::size_t>(getmaxy(stdscr)); }

void CursesTerminal::draw(const Canvas& canvas) {
  werase(stdscr);
  for (std::size_t row = 0; row < canvas.height(); ++row) {
    for (std::size_t column = 0; column < canvas.width(); ++column) {
      const Cell& cell = canvas.at(row, column);
      const Look look = look_of(cell.style, colours_);
      const char32_t glyph = unicode_ || cell.glyph < 0x80 ? cell.glyph : U'?';
      const std::array<wchar_t, 2> text{static_cast<wchar_t>(glyph), L'\0'};
      cchar_t drawn{};
      setcchar(&drawn, text.data(), look.attributes, look.pair, nullptr);
      mvwadd_wch(stdscr, static_cast<int>(row), static_cast<int>(column), &drawn);
    }
  }
  wrefresh(stdscr);
}

std::optional<KeyPress> CursesTerminal::key() {
  const int code = wgetch(stdscr);
  return code == ERR ? std::nullopt : key_press(code);
}

}  // namespace drydock::monitor
