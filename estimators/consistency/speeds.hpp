#pragma once

#include "drivers/diagnosis/symptom.hpp"
#include "estimators/consistency/current.hpp"
#include "estimators/consistency/first_offset.hpp"
#include "estimators/consistency/group.hpp"
#include "estimators/consistency/moment.hpp"
#include "estimators/consistency/shaft_law.hpp"

namespace drydock::consistency {

/// Speed over ground along the deck, the body's xy plane: DVL, GNSS, log with the current, shaft.
/// It needs no heading, so a wrong heading accuses none of them.
class Speeds {
 public:
  explicit Speeds(const Tracks& tracks);

  template <class Distrusted>
  void step(const Moment& moment, const Distrusted& distrusted) {
    see(moment);
    group_.settle(moment.at, moment.dt, distrusted);
    group_.anchor(moment.dt);
    ahead_.settle(moment.at, moment.dt, distrusted);
    learn(moment);
  }

  /// Test::acquit for all tests that are of no doubtful device that tells motion.
  void acquit(Stamp since, const Doubts& doubts) {
    group_.acquit(since, doubts);
    ahead_.acquit(since, doubts);
  }

  void note_fault(std::uint16_t device);
  void forget(std::uint16_t device, Stamp since) {
    group_.forget(device, since);
    ahead_.forget(device, since);
  }

  const Group& group() const { return group_; }
  /// Speed ahead: of each DVL, and of the first log with the current.
  const Group& ahead() const { return ahead_; }
  /// The speed along the deck less the current; empty if nothing tells how the water moves.
  std::optional<double> through_water(const Moment& moment) const;

  /// A DVL has been wrong since then. What was learned beside it, if for the longer part of the
  /// time it was wrong, begins anew.
  void forget_dvl(Stamp since, Stamp now);

  /// One of three speeds was off from the start on.
  const std::optional<FirstOffset>& off() const { return off_; }
  std::optional<std::uint16_t> dvl_off() const;
  /// Repeats the sign of a speed that was off from the start, while it lasts.
  void tell(Stamp now, diagnosis::SymptomSink& to) const;

 private:
  void see(const Moment& moment);
  void see_dvls(const Moment& moment);
  void see_receivers(const Moment& moment);
  void see_logs(const Moment& moment);
  void see_shafts(const Moment& moment);
  void learn(const Moment& moment);
  void learn_currents(const Moment& moment);
  void judge_offset(Stamp at);
  bool is_log_off() const;
  void forget_shafts();
  std::optional<double> dvl_over_receiver() const;
  void learn_surge(const Moment& moment);
  bool is_quiet(std::size_t witness) const;
  bool is_accused(std::size_t witness) const;
  std::optional<double> speed_of_others() const;
  static double starboard(const Moment& moment);
  Eigen::Vector2d current(const Moment& moment) const;
  static Eigen::Vector2d along_deck(double speed_mps, const Moment& moment);
  double current_sigma(std::size_t log, const Moment& moment) const;
  Eigen::Vector2d water(std::size_t log, const Eigen::Vector2d& read, const Moment& moment) const;

  const Tracks& tracks_;
  Group group_, ahead_;
  std::vector<std::size_t> dvls_, receivers_, logs_, shafts_, dvls_ahead_, logs_ahead_;
  std::vector<Current> currents_;      ///< one a log
  std::vector<Current> off_currents_;  ///< the same of a log that may be far off from the start
  std::optional<FirstOffset> off_;     ///< of the first DVL, receiver or log
  std::optional<Stamp> first_;         ///< when a log was first compared
  std::vector<std::uint64_t> compared_, learned_;  ///< the last sample of each log that did so
  std::vector<ShaftLaw> shaft_laws_;               ///< one a shaft
  std::vector<bool> shafts_at_fault_;              ///< at the coming time: they teach nothing
};

}  // namespace drydock::consistency
