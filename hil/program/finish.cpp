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

/// Why standard output takes nothing more. The C library forgets it, so the kernel is asked again.
std::string write_trouble() {
  errno = 0;
  const bool taken = ::write(STDOUT_FILENO, "\n", 1) == 1;
  return taken ? "a part of it is missing" : std::strerror(errno);
}

bool all_written() {
  std::cout.flush();
  return std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

}  // namespace

int finish(int code) {
  if (!all_written()) {
    fmt::print(stderr, "drydock: standard output cannot be written: {}\n", write_trouble());
    if (code == terminal::exit_success) code = terminal::exit_failed;
  }
  const bool wrong_usage = code == terminal::exit_usage;
  return terminal::ended_early() && !wrong_usage ? terminal::exit_interrupted : code;
}

}  // namespace drydock::program
