#pragma once

#include "hil/bench/follower.hpp"
#include "hil/validity/figures.hpp"

namespace drydock::validity {

/// Tells a listener what emulated devices sent and what their drivers made of it.
class SentAndHeard : public bench::Follower {
 public:
  /// The listener must outlive it.
  explicit SentAndHeard(validity::Listener& listener) : listener_(listener) {}

  void on_written(std::string_view device, const emulate::Passage& passage,
                  Stamp written) override {
    listener_.note(device, passage, written);
  }
  void on_measurement(const measurement::Measurement& m) override { listener_.note(m); }

 protected:
  validity::Listener& listener_;
};

}  // namespace drydock::validity
