#pragma once

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "drivers/bus/device.hpp"

namespace drydock::host {

/// The health of all devices at one time. Its text is made once, when a follower first asks for it:
/// a run in virtual time without a recording makes none.
class HealthReport {
 public:
  using Statuses = std::vector<bus::DeviceStatus>;

  explicit HealthReport(std::function<Statuses()> make) : make_(std::move(make)) {}

  std::span<const bus::DeviceStatus> statuses() const {
    if (!made_) made_ = make_();
    return *made_;
  }

 private:
  std::function<Statuses()> make_;
  mutable std::optional<Statuses> made_;
};

}  // namespace drydock::host
