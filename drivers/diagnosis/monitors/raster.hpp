#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "drivers/diagnosis/monitors/host_lateness.hpp"
#include "drivers/diagnosis/monitors/spread.hpp"
#include "drivers/measurement/stamp.hpp"

namespace drydock::diagnosis {

using measurement::Stamp;

/// How one message came after the one before it, against the usual period.
enum class Step : std::uint8_t {
  first,    ///< none before it, or the raster is not known yet
  regular,  ///< one period later
  missing,  ///< several periods later: those between did not come, or come late
  crowded,  ///< right behind the one before it
  odd       ///< at no place of the raster
};

/// The raster in which the messages of one kind arrive. The period and the scatter are those of the
/// device's own first time. Where a rig states the rate, a stream that loses messages from the
/// start has that raster. A stream whose messages come at no raster is never judged.
class Raster {
 public:
  static constexpr std::chrono::seconds learning{30};
  static constexpr std::size_t fewest = 20;  ///< intervals to learn from

  struct Arrival {
    Step step = Step::first;
    double interval_s = 0;   ///< since the last message that was not crowded
    long slots = 0;          ///< the interval in periods
    bool host_held = false;  ///< this computer may have held the one before until this one came
  };

  /// `nominal_rate_hz`: as the rig states it; 0: it states none.
  explicit Raster(double nominal_rate_hz = 0)
      : nominal_s_(nominal_rate_hz > 0 ? 1 / nominal_rate_hz : 0) {}

  /// `behind_s`: how long after the message before it, of any kind, the device sent this one. A
  /// message that waits for another on the line comes sooner without it. `host`: what this computer
  /// may have added; a message that is late by no more keeps its place, and is regular.
  Arrival add(Stamp at, double behind_s = 0, HostLate host = {});
  /// The next message has none before it: the device was away.
  void interrupt() { last_.reset(); }

  bool known() const { return state_ == State::known; }
  double period_s() const { return period_s_; }
  double tolerance_s() const { return tolerance_s_; }  ///< of an interval that is regular
  /// The share of messages that did not come in the first time; 0: they all came.
  double missing_share() const { return missing_share_; }
  Stamp first_missing() const { return first_missing_; }
  /// How long a message usually waits behind another one of the device. 0: it does not.
  double waits_s() const { return waits_s_; }
  /// What the line may add to an interval: messages wait for others, or the others do not come.
  void allow(double line_s);

 private:
  enum class State : std::uint8_t { learns, known, has_none };
  void learn(Stamp at, double behind_s);
  void settle();
  bool fold();
  bool has_little_scatter(double most_share);
  bool is_crowded(double interval_s, double since_any_s) const;
  Arrival judge(Stamp at);
  bool may_be_late(HostLate host, double off_s, Step step) const;

  State state_ = State::learns;
  Spread<256> intervals_, behind_;
  std::optional<Stamp> first_, last_;
  double begun_late_s_ = 0;  ///< of last_, if it has none before it: by the computer
  Stamp any_{};              ///< the latest message, crowded or not
  long owed_ = 0;            ///< messages that did not come in the last pause and may still do
  double period_s_ = 0, tolerance_s_ = 0, waits_s_ = 0, allowed_s_ = 0;
  double nominal_s_, missing_share_ = 0;
  Stamp first_missing_{};
  double learned_s_ = 0;  ///< intervals together
  long intervals_learned_ = 0;
};

}  // namespace drydock::diagnosis
