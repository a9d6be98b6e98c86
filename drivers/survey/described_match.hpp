#pragma once

#include <map>
#include <string>
#include <vector>

#include "drivers/survey/arrivals.hpp"
#include "drivers/wire/described/description.hpp"
#include "drivers/wire/described/frame_plan.hpp"

namespace drydock::survey {

/// An identifier as it stands on the wire.
struct BusId {
  std::uint32_t id = 0;
  bool extended = false;
  auto operator<=>(const BusId&) const =
      default;  // NOLINT(modernize-use-nullptr): clang 14 takes it for a 0
};

/// What the frames of a bus say for a description with a DBC file, and against it: identifiers,
/// lengths, checksums, counters and cycle times.
class DescribedMatch {
 public:
  explicit DescribedMatch(wire::described::DescriptionPtr description);

  /// False for a frame that is none of its messages.
  bool receive(const wire::CanFrame& frame, measurement::Stamp at);

  bool has(BusId id) const;
  const std::map<BusId, Arrivals>& heard() const { return heard_; }

  /// Hardly a frame contradicts. One may be damaged however few they are.
  bool fits() const;
  /// Nothing contradicts, and all came that a sample waits for.
  bool fits_in_all() const;
  /// `2 of 2 messages, all frames as long as described, checksums right, ...`.
  std::string in_words() const;

 private:
  struct MessageHeard {
    Arrivals arrivals;
    std::uint64_t other_length = 0, checked = 0, damaged = 0, counted = 0, jumps = 0;
    wire::dbc::FrameCounter counter;
  };
  struct Totals {
    std::size_t messages = 0, awaited = 0, cycles = 0, cycles_kept = 0;
    std::uint64_t frames = 0, other_length = 0, checked = 0, damaged = 0, counted = 0, jumps = 0;
    std::string missing, other_cycles;
  };

  void follow_counter(std::size_t place, const wire::CanFrame& frame);
  Totals totals() const;

  wire::described::DescriptionPtr description_;
  std::vector<MessageHeard> messages_;  ///< in the order of the plan
  std::map<BusId, Arrivals> heard_;
  std::vector<wire::dbc::Value> values_;
};

}  // namespace drydock::survey
