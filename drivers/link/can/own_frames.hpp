#pragma once

#include <algorithm>
#include <boost/circular_buffer.hpp>

#include "drivers/wire/can/can_frame.hpp"

namespace drydock::link {

/// The frames that were written last, for an adapter that repeats what it is told: they must not be
/// taken for those of another node.
class OwnFrames {
 public:
  explicit OwnFrames(std::size_t most) : written_(most) {}

  void add(const wire::CanFrame& frame) { written_.push_back(frame); }

  /// True if the frame is one of them. Those before it were not repeated and are forgotten too.
  bool take_echo(const wire::CanFrame& frame) {
    const auto own = std::find(written_.begin(), written_.end(), frame);
    if (own == written_.end()) return false;
    written_.erase(written_.begin(), own + 1);
    return true;
  }

 private:
  boost::circular_buffer<wire::CanFrame> written_;
};

}  // namespace drydock::link
