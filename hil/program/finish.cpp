#include "hil/program/finish.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>
#include <string>

#include "drivers/terminal/early_end.hpp"
#include "drivers/terminal/exit_codes.hpp"

namespace drydock::program {

namespace {

constexpr int took_again = -1;  ///< no number of errno

/// Why standard output takes nothing more. The C library forgets it, so the kernel is asked again.
int write_trouble() { return ::write(STDOUT_FILENO, "\n", 1) == 1 ? took_again : errno; }

bool all_written() {
  std::cout.flush();
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

}  // namespace

int finish(int code) {
  const int why = all_written() ? 0 : write_trouble();
  if (why != 0 && why != EPIPE) {  // nobody misses the last lines behind `| head`
    fmt::print(stderr, "drydock: standard output cannot be written: {}\n",
               why == took_again ? "a part of it is missing" : std::strerror(why));
    if (code == terminal::exit_success) code = terminal::exit_failed;
  }
  const bool wrong_usage = code == terminal::exit_usage;
  return terminal::ended_early() && !wrong_usage ? terminal::exit_interrupted : code;
}

}  // namespace drydock::program
