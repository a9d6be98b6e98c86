#include "drivers/link/serial/pty_listeners.hpp"

#include <sys/inotify.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>

namespace drydock::link {

boost::system::result<PtyListeners> PtyListeners::watch(const std::string& device) {
  Descriptor events(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC));
  if (!events || ::inotify_add_watch(events.get(), device.c_str(), IN_OPEN | IN_CLOSE) < 0)
    return boost::system::error_code(errno, boost::system::system_category());
  return PtyListeners(std::move(events));
}

bool PtyListeners::opened_since() {
  bool opened = false;
  std::array<char, 1024> buffer;
  for (;;) {
    const ssize_t size = ::read(events_.get(), buffer.data(), buffer.size());
    if (size <= 0) return opened;
    // The watch is on a file, not on a directory: events have no name and all have one size.
    for (ssize_t at = 0; at < size; at += static_cast<ssize_t>(sizeof(inotify_event))) {
      inotify_event event;
      std::memcpy(&event, buffer.data() + at, sizeof event);
      present_ = (event.mask & IN_OPEN) != 0;
      opened = opened || present_;
    }
  }
}

}  // namespace drydock::link
