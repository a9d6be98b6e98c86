#pragma once

#include <boost/system/result.hpp>
#include <string>

#include "drivers/link/descriptor.hpp"

namespace drydock::link {

/// Tells whether another program has a terminal device open (inotify).
class PtyListeners {
 public:
  /// It ignores openings before this call.
  static boost::system::result<PtyListeners> watch(const std::string& device);

  /// Processes the events since the last call. True if somebody has opened the device since then.
  bool opened_since();

  /// True if somebody opened it and nobody has left since. With several programs, the first that
  /// leaves makes it false until another one opens the device.
  bool present() const { return present_; }

 private:
  explicit PtyListeners(Descriptor events) : events_(std::move(events)) {}

  Descriptor events_;
  bool present_ = false;
};

}  // namespace drydock::link
