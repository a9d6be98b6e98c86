#pragma once

#include <optional>

#include "drivers/diagnosis/monitors/spread.hpp"
#include "drivers/measurement/stamp.hpp"

namespace drydock::diagnosis {

using measurement::Stamp;

/// A device's own clock against arrival, for the messages of one kind. What is usual are the median
/// and the scatter of the device's own first time.
class ClockWatch {
 public:
  static constexpr std::chrono::seconds learning{30};

  struct News {
    double jump_s = 0;       ///< arrival minus device time against the usual one; 0: as usual
    bool backwards = false;  ///< the device time is before that of the message before
    bool repeated = false;   ///< the device time is that of the message before
    bool aged = false;       ///< the device itself says that its values are older by that jump
  };

  News add(std::chrono::nanoseconds device, Stamp arrival, Stamp valid_at);
  /// What is now is usual from now on.
  void accept();
  /// The clock drifts: what is usual follows it.
  void follow() { usual_s_ += (latest_s_ - usual_s_) / 16; }
  double limit_s() const { return limit_s_; }
  bool known() const { return known_; }

 private:
  void learn(double offset_s, double age_s, Stamp arrival);
  void keep_pace(double jump_s, Stamp arrival);

  bool known_ = false;
  bool repeats_when_sound_ = false, goes_back_when_sound_ = false;
  Spread<128> offsets_;  ///< against the first one
  Spread<128> ages_;
  double usual_age_s_ = 0;
  std::optional<Stamp> first_, before_;
  double base_s_ = 0, usual_s_ = 0, limit_s_ = 0, latest_s_ = 0;
  std::optional<std::chrono::nanoseconds> last_;
};

}  // namespace drydock::diagnosis
