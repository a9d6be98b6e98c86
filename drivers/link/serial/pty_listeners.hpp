#pragma once

#include <boost/system/result.hpp>
#include <string>

#include "drivers/link/descriptor.hpp"

namespace drydock::link {

/// Knows whether another program has a terminal device open (inotify).
class PtyListeners {
 public:
  /// Openings before this call do not count.
  static boost::system::result<PtyListeners> watch(const std::string& device);

  /// Takes in what happened since the last call. True when somebody has opened the device since.
  bool opened_since();

  /// Somebody opened it and nobody has left since. With several programs on it the first that
  /// leaves makes this false, until the next one comes.
  bool present() const { return present_; }

 private:
  explicit PtyListeners(Descriptor events) : events_(std::move(events)) {}

  Descriptor events_;
  bool present_ = false;
};

}  // namespace drydock::link
