#pragma once

#include <optional>

#include "drivers/device/health.hpp"
#include "drivers/diagnosis/monitors/expected.hpp"
#include "drivers/diagnosis/monitors/frame_count.hpp"
#include "drivers/diagnosis/monitors/teller.hpp"

namespace drydock::diagnosis {

/// Watches the line of one device by the counters of its driver: silence, lost ports, damaged
/// frames, foreign bytes, bytes that no one understands, CAN errors, reported heat, refusals and
/// errors, a rate that is not the one of the rig.
class LineMonitor {
 public:
  /// The sink must outlive the monitor.
  LineMonitor(const Expected& expected, SymptomSink& to);

  /// `counts`: what came in the first time is the usual number of frames.
  void look(const device::Vitals& vitals, Stamp now, bool counts = true);
  /// This program stood still until `now`: what its driver missed in that time is no fault of a
  /// device that streamed before.
  void interrupt(Stamp now);

 private:
  void look_at_state(const device::Vitals& vitals, Stamp now);
  bool is_silent(const device::Vitals& vitals, Stamp now) const;
  void look_at_bytes(const device::Vitals& vitals, Stamp now);
  void look_at_counters(const device::Vitals& vitals, Stamp now, bool counts);
  void look_at_skipped(double bytes, bool damaged, const device::Vitals& vitals, Stamp now);
  void look_at_reports(const device::Vitals& vitals, Stamp now);
  void look_at_rate(const device::Vitals& vitals, Stamp now);
  void look_at_share_of_line(const device::Vitals& vitals, Stamp now);

  Expected expected_;
  Teller teller_;
  device::Vitals last_{};
  bool looked_ = false;
  Stamp last_frame_{};  ///< when the counter of good frames last moved
  Stamp bytes_at_{};    ///< when bytes last came
  std::uint64_t bytes_then_ = 0, not_text_then_ = 0, damaged_then_ = 0;
  FrameCount frames_;
  double foreign_ = 0;  ///< bytes outside of frames, behind which no frame has come yet
  Stamp foreign_at_{};
  Stamp hot_since_{}, hot_until_{};
  Stamp refused_since_{}, refused_until_{};
  Stamp error_since_{}, error_until_{};
  std::optional<Stamp> silent_at_, damaged_at_;
  Stamp catches_up_until_{};  ///< after this program stood still
  std::optional<Stamp> off_rate_since_;
  std::uint64_t bytes_when_off_rate_ = 0;
  bool had_its_rate_ = false;
};

}  // namespace drydock::diagnosis
