#pragma once

#include <functional>
#include <string>

#include "drivers/host/follower.hpp"
#include "drivers/host/redrawn_lines.hpp"
#include "drivers/shell/real_time.hpp"

namespace drydock::host {

/// How a run stands: "12 s of 60 s, 48 s left  2.3 MB  dvl 5.00 Hz  gnss 4.99 Hz".
struct RunStanding {
  double elapsed_s = 0, duration_s = 0;                  ///< duration 0: without an end
  std::optional<std::uint64_t> recorded;                 ///< bytes; empty: no recording
  std::vector<std::pair<std::string, double>> rates_hz;  ///< by device
};
std::vector<std::string> rate_words(const RunStanding& standing);  ///< "dvl 5.00 Hz"
std::vector<std::string> standing_lines(const RunStanding& standing, std::size_t width);

/// Keeps a line with the standing, or several on a narrow terminal, below the lines that others
/// print, on a terminal that can erase a line. Elsewhere it prints nothing. Added first, so that it
/// makes room for the others' lines.
class StatusLine final : public Follower {
 public:
  using Ask = std::function<RunStanding()>;
  explicit StatusLine(Ask ask);

  void on_state(const device::Device&, const device::Transition&) override { wipe(); }
  void on_finding(const diagnosis::Finding&) override { wipe(); }
  void tick(Stamp now) override;  ///< draws the lines, twice a second
  void wipe() { lines_.wipe(); }

 private:
  Ask ask_;
  bool terminal_;
  RedrawnLines lines_{stdout};
  Stamp next_{};
};

}  // namespace drydock::host
