#include "drivers/monitor/places_cursor.hpp"

#include <unistd.h>
#include <cstdint>

#include <curses.h>
#include <term.h>  // it defines common words as macros, so nothing else is in this file

namespace drydock::monitor {

bool places_cursor() {
  if (::isatty(STDOUT_FILENO) != 1) return false;
  int error = 0;
  if (setupterm(nullptr, STDOUT_FILENO, &error) != OK) return false;
  const char* way = tigetstr(const_cast<char*>("cup"));
  const bool found = way != nullptr && reinterpret_cast<std::intptr_t>(way) != -1;
  del_curterm(cur_term);
  return found;
}

}  // namespace drydock::monitor
