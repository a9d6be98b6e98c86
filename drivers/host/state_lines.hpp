#pragma once

#include <cstdio>
#include <optional>

#include "drivers/host/follower.hpp"

namespace drydock::host {

/// Prints one line for each change of a device's state.
class StateLines final : public Follower {
 public:
  /// With a start, each line begins with the seconds since then.
  explicit StateLines(std::FILE* out, std::optional<Stamp> start = {}) : out_(out), start_(start) {}

  void on_state(const device::Device& device, const device::Transition& change) override;

 private:
  std::FILE* out_;
  std::optional<Stamp> start_;
};

}  // namespace drydock::host
