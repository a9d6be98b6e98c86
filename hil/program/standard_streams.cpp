#include "hil/program/standard_streams.hpp"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <string_view>
#include <tuple>

#include "drivers/terminal/progress_bar.hpp"
#include "drivers/text/printable.hpp"

namespace drydock::program {
namespace {

/// Descriptors are given from the lowest on, so each of the three is the one that was closed.
void fill_closed_descriptors() {
  struct Stream {
    int descriptor, flags;
  };
  constexpr std::array streams{Stream{STDIN_FILENO, O_WRONLY}, Stream{STDOUT_FILENO, O_RDONLY},
                               Stream{STDERR_FILENO, O_WRONLY}};
  for (const auto& [descriptor, flags] : streams)
    if (::fcntl(descriptor, F_GETFD) == -1 && errno == EBADF) ::open("/dev/null", flags);
}

/// A progress bar draws over its lines, and no other sequence stays.
std::string shown(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    std::size_t at = text.size();
    std::string_view kept;
    for (const std::string_view wipe : {terminal::wipe_line, terminal::wipe_line_above}) {
      const auto found = text.find(wipe);
      if (found < at) std::tie(at, kept) = std::tie(found, wipe);
    }
    out += text::printable_lines(text.substr(0, at));
    out += kept;
    text.remove_prefix(at + kept.size());
  }
  return out;
}

/// Nobody can be told that a message was lost.
ssize_t write_message(void*, const char* text, size_t size) {
  const std::string message = shown({text, size});
  std::string_view rest = message;
  while (!rest.empty()) {
    const auto written = ::write(STDERR_FILENO, rest.data(), rest.size());
    if (written < 0 && errno != EINTR) break;
    if (written > 0) rest.remove_prefix(static_cast<std::size_t>(written));
  }
  return static_cast<ssize_t>(size);
}

}  // namespace

void guard_standard_streams() {
  fill_closed_descriptors();
  std::FILE* messages = ::fopencookie(nullptr, "w", {nullptr, write_message, nullptr, nullptr});
  if (messages == nullptr) return;
  std::setvbuf(messages, nullptr, _IONBF, 0);
  messages->_fileno = STDERR_FILENO;  // whether it is a terminal is asked by this number
  stderr = messages;
}

}  // namespace drydock::program
