#pragma once

#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/host/follower.hpp"
#include "rig_config/rig.hpp"

namespace drydock::host {

/// "nothing was heard or asked for 8.0 s: this program ...".
std::string stall_line(double for_s);

/// One line when a finding begins, one when it is over, and one for a stall of this computer.
class FindingLines final : public Follower {
 public:
  using Print = std::function<void(const std::string& line)>;

  /// `start`: the time from which the lines count. The rig must outlive the lines.
  FindingLines(const rig_config::Rig& rig, Stamp start, Print print)
      : rig_(rig), start_(start), print_(std::move(print)) {}

  void on_finding(const diagnosis::Finding& finding) override;
  void on_stall(Stamp from, Stamp to) override;
  void on_clock_step(std::chrono::nanoseconds step) override { start_ += step; }

 private:
  const rig_config::Rig& rig_;
  Stamp start_;
  Print print_;
};

}  // namespace drydock::host
