#pragma once

#include <boost/container/static_vector.hpp>
#include <cmath>
#include <limits>
#include <span>

#include "estimators/consistency/devices.hpp"
#include "estimators/consistency/doubts.hpp"
#include "estimators/consistency/test.hpp"

namespace drydock::consistency {

/// One way in which a device tells the common quantity of a group. A second device may be needed
/// to make the value, as the drift angle of the DVL makes a heading from the GNSS course.
struct Witness {
  Devices devices;
  Test test;
  const Freeze* freeze = nullptr;
  bool kin = false;  ///< it shares an error with its kin: together they have one vote
  // of this time
  bool seen = false, fresh = false, present = false, votes = false;
  bool at_fault = false;  ///< its device's own samples show it: they teach nothing
  double value = 0, sigma = 0;
  double alone_s = 0;           ///< how long no other has been seen
  double spread = 0, wide = 0;  ///< the test's spread, and with sigma
  std::uint64_t serial = 0;

  void measure() {
    spread = test.spread();
    wide = sigma == 0 ? spread : std::hypot(spread, sigma);
  }
};

/// Sensors that say the same quantity, each with its own offset. A witness is tested against the
/// median of all: up to half of them may be wrong. Two witnesses accuse each other.
class Group {
 public:
  static constexpr std::size_t most = 32;

  /// Values that differ by a whole number of `period` are the same: 2 pi for headings. A witness
  /// that was silent while the vehicle turned does not know how often it did.
  explicit Group(double period = std::numeric_limits<double>::infinity()) : period_(period) {}

  /// Adds a witness; its number counts from 0. A group that is full gives the number `most`,
  /// which stands for a witness that says nothing and is not tested.
  std::size_t add(const Devices& devices, const TestFacts& facts, const Freeze* freeze = nullptr,
                  bool kin = false);

  /// What a witness says at the coming time. `serial`: of the sample, the same one is not tested
  /// twice. `sigma`: of errors that are larger than usual now.
  void see(std::size_t witness, double value, std::uint64_t serial, double sigma = 0);

  /// The value of a witness has no memory of earlier times: after an outage its sum begins anew.
  void restart(std::size_t witness) {
    if (witness < witnesses_.size()) witnesses_[witness].test.restart();
  }

  /// The same of all.
  void restart() {
    for (Witness& witness : witnesses_) witness.test.restart();
  }

  /// Test::acquit for the witnesses that are of no doubtful device that tells motion.
  void acquit(Stamp since, const Doubts& doubts) {
    for (Witness& witness : witnesses_)
      if (!doubts.tells_motion(witness.devices)) witness.test.acquit(since);
  }

  /// The sums of the device begin anew: what went into them was wrong.
  void restart_sums(std::uint16_t device) {
    for (Witness& witness : witnesses_)
      if (contains(witness.devices, device) && witness.test.facts().sum_above <= 0)
        witness.test.restart();
  }

  /// At the coming time the device's own samples show that it is at fault.
  void note_fault(std::uint16_t device) {
    for (Witness& witness : witnesses_)
      if (contains(witness.devices, device)) witness.at_fault = true;
  }

  /// Test::forget for all witnesses of the device.
  void forget(std::uint16_t device, Stamp since) {
    for (Witness& witness : witnesses_)
      if (contains(witness.devices, device)) witness.test.forget(since);
  }

  /// Tests all that was seen. `distrusted(devices)`: they do not count for the median.
  template <class Distrusted>
  void settle(Stamp at, double dt, const Distrusted& distrusted);

  /// Draws the median of the offsets to 0, of those that speak now. The tests see differences only,
  /// so all offsets together would walk away, and the median of the witnesses with them.
  void anchor(double dt);

  /// The median of the last time and its derivative.
  std::optional<double> value() const { return value_; }
  double rate() const { return rate_; }

  std::span<const Witness> witnesses() const { return {witnesses_.data(), witnesses_.size()}; }
  /// The devices that a fired witness accuses: its own, or those of both of two.
  Devices accused(const Witness& witness) const;

 private:
  using Values = boost::container::static_vector<double, most>;
  struct Votes {
    Values single, kin;
    void add(double value, bool of_kin) { (of_kin ? kin : single).push_back(value); }
    std::size_t count() const { return single.size() + (kin.empty() ? 0 : 1); }
    std::optional<double> median() const;
  };
  void move_to(std::optional<double> value, double dt);
  static void note_alone(Witness& witness, double dt, std::size_t seen);
  void test(Witness& witness, Stamp at, std::size_t seen) const;
  double sigma_among_others(const Witness& witness) const;
  double shared_with_kin(const Witness& witness) const;

  double period_;
  boost::container::static_vector<Witness, most> witnesses_;
  std::optional<double> value_;
  double rate_ = 0;
  std::size_t voters_ = 0;
  double worst_sigma_ = 0;         ///< of all: two witnesses cannot be better than the worse
  const Witness* sole_ = nullptr;  ///< the only one that votes: nothing tests it
};

template <class Distrusted>
void Group::settle(Stamp at, double dt, const Distrusted& distrusted) {
  Votes sound, trusted, any;
  const Witness* voter = nullptr;
  double worst = 0;
  for (Witness& witness : witnesses_) {
    witness.votes = false;
    if (!witness.seen) continue;
    witness.measure();
    worst = std::max(worst, witness.wide);
    const double value = witness.value - witness.test.offset();
    any.add(value, witness.kin);
    if (!witness.test.learned() || distrusted(witness.devices)) continue;
    voter = &witness;
    trusted.add(value, witness.kin);
    witness.votes = !witness.test.fired();
    if (witness.votes) sound.add(value, witness.kin);
  }
  voters_ = sound.count();
  worst_sigma_ = worst;
  sole_ = trusted.single.size() + trusted.kin.size() == 1 ? voter : nullptr;
  move_to((sound.count() > 0 ? sound : trusted.count() > 0 ? trusted : any).median(), dt);
  const std::size_t seen = any.single.size() + any.kin.size();
  for (Witness& witness : witnesses_) {
    note_alone(witness, dt, seen);
    test(witness, at, seen);
  }
}

}  // namespace drydock::consistency
