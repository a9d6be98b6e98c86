#pragma once

#include <vector>

#include "drivers/diagnosis/finding.hpp"
#include "drivers/diagnosis/verdict.hpp"

namespace drydock::diagnosis {

/// Collects the signs of all monitors and says what is wrong with which device: at most one finding
/// a device is open at a time. Sans-I/O; no allocation after construction.
class Judge final : public SymptomSink {
 public:
  /// The listener must outlive the judge.
  Judge(std::size_t devices, FindingListener& to);

  void see(const Symptom& symptom) override;

  /// Weighs the signs and tells the listener what has begun, changed or ended. Call it a few times
  /// a second, and before it `see` for all signs that last.
  void settle(Stamp now);

  /// Nothing more is known from then on: tells the listener the end of all findings.
  void end_all(Stamp until);

  /// The open finding of a device; null: none.
  const Finding* open(std::uint16_t device) const;

 private:
  using Signs = boost::container::static_vector<Symptom, 40>;
  struct Case {
    Signs signs;  ///< each sign once, the latest of each
    std::optional<Finding> finding;
    Sign decided_by = Sign::silent;  ///< about the finding
    Stamp decided_at{};              ///< when that sign was seen last
  };
  static Signs::const_iterator find(const Case& one, Sign sign);
  static void note_decided(Case& one, Sign by);
  static void forget_old(Case& one, Stamp now);
  static void forget_explained(Case& one);
  /// Returns the ended finding.
  std::optional<Finding> end(Case& one, Stamp now);
  void begin(Case& one, std::uint16_t device, const Verdict& verdict,
             const std::optional<Finding>& before, Stamp now);

  std::vector<Case> cases_;
  FindingListener& to_;
};

}  // namespace drydock::diagnosis
