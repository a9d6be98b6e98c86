#include "hil/program/dash_output.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

namespace drydock::program {
namespace {

/// In memory, since a pipe cannot be opened again by its name, and a file that is appended to must
/// not be cut. -1: no file is a dash.
int held = -1;
int standard_output = -1;  ///< while it is kept

std::string hold(std::string& text) {
  if (text != "-") return {};
  if (held >= 0) return "- is standard output, which one file may be";
  held = ::memfd_create("standard-output", MFD_CLOEXEC);
  if (held < 0) return std::string("no memory for standard output: ") + std::strerror(errno);
  text = fmt::format("/proc/self/fd/{}", held);
  return {};
}

}  // namespace

void take_dash(CLI::Option& option) { option.transform(CLI::Validator(hold, "")); }

void begin_dash() {
  if (held < 0) return;
  std::fflush(stdout);
  standard_output = ::dup(STDOUT_FILENO);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
}

void end_dash() {
  if (standard_output < 0) return;
  std::fflush(stdout);
  ::dup2(standard_output, STDOUT_FILENO);
  ::close(standard_output);
  standard_output = -1;
  std::array<char, 65536> block;
  ::lseek(held, 0, SEEK_SET);
  for (ssize_t size = 0; (size = ::read(held, block.data(), block.size())) > 0;)
    std::fwrite(block.data(), 1, static_cast<std::size_t>(size), stdout);
}

}  // namespace drydock::program
