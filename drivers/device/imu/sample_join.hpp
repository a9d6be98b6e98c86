#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>

#include "drivers/device/driver.hpp"
#include "drivers/device/imu/sample_pace.hpp"

namespace drydock::device {

/// Decides whether frames that follow each other in the right order are of one sample, for a device
/// that counts nothing. A busy host may have read them far apart, or frames between them were lost:
/// the last ones of a sample and the first ones of the next, which the order does not show. Frames
/// within 5 ms are of one sample, and so are those that came before the next sample could have. Of
/// the others those tell that come behind them: either they catch up with the device's pace, then
/// all frames came, or eight keep a period behind it. Until then all samples wait.
class SampleJoin {
 public:
  static constexpr std::chrono::milliseconds close{5};

  void reset() {
    pace_.reset();
    size_ = 0;
  }

  /// The first frame of a sample came.
  void begins(Stamp at, Output& out) {
    const bool waited_for = at - begun_at_ > pace_.period() / 2;
    begun_at_ = at;
    pace_.next(at, size_ > 0);
    if (pace_.is_in_time(at)) {
      let_out(0, out);
    } else if (size_ == 0) {
      pace_.go_on_from(at);
    } else if (waited_for && ++behind_ == most_behind) {
      give_up_first(out);
      pace_.go_on_from(at);
    }
  }

  /// The first frame of a sample was lost.
  void misses() { pace_.miss(); }

  /// All frames of a sample came in their order. The sample is empty if it is no measurement.
  void completes(const std::optional<measurement::ImuSample>& sample, Stamp first, Stamp last,
                 Output& out) {
    const bool are_close = last - first <= closeness();
    if (size_ == 0 && !are_close && !pace_.known()) {
      out.report("frames of one sample came over 5 ms apart: some were lost, or the host was late");
    } else if (size_ == 0 && (are_close || pace_.is_in_time(last))) {
      if (sample) out.publish(*sample);
    } else if (sample) {
      if (size_ == 0) behind_ = 0;
      if (size_ == held_.size()) give_up_first(out);
      held_[size_++] = *sample;
    }
  }

  /// No more frames come.
  void finish(Output& out) {
    if (size_ > 0) give_up_first(out);
  }

 private:
  static constexpr unsigned most_behind = 8;  ///< samples that were read in their own time

  /// Of a fast device it is less than a period.
  Stamp::duration closeness() const {
    if (!pace_.known()) return close;
    return std::min<Stamp::duration>(close, pace_.period() / 2);
  }

  void let_out(std::size_t from, Output& out) {
    for (std::size_t i = from; i < size_; ++i) out.publish(held_[i]);
    size_ = 0;
  }

  void give_up_first(Output& out) {
    out.refuse("frames of one sample came over a period apart: those between were lost",
               Refusal::incomplete);
    let_out(1, out);
  }

  SamplePace pace_;
  std::array<measurement::ImuSample, 64> held_{};
  std::size_t size_ = 0;
  unsigned behind_ = 0;
  Stamp begun_at_{};
};

}  // namespace drydock::device
