#pragma once

#include <functional>
#include <string>

#include "drivers/host/follower.hpp"
#include "drivers/shell/real_time.hpp"

namespace drydock::host {

/// How a run stands: "12 s of 60 s, 48 s left  2.3 MB  dvl 5.00 Hz  gnss 4.99 Hz".
struct RunStanding {
  double elapsed_s = 0, duration_s = 0;                  ///< duration 0: without an end
  std::optional<std::uint64_t> recorded;                 ///< bytes; empty: no recording
  std::vector<std::pair<std::string, double>> rates_hz;  ///< by device
};
/// Cut at `width` columns.
std::string standing_text(const RunStanding& standing, std::size_t width);

/// Keeps one line with the standing below the lines that others print, on a terminal that can erase
/// a line. Elsewhere it prints nothing. Added first, so that it makes room for the others' lines.
class StatusLine final : public Follower {
 public:
  using Ask = std::function<RunStanding()>;
  explicit StatusLine(Ask ask);

  void on_state(const device::Device&, const device::Transition&) override { wipe(); }
  void on_finding(const diagnosis::Finding&) override { wipe(); }
  void tick(Stamp now) override;  ///< draws the line, twice a second
  void wipe();

 private:
  Ask ask_;
  bool terminal_;
  bool drawn_ = false;
  Stamp next_{};
};

}  // namespace drydock::host
