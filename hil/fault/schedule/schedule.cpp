#include "hil/fault/schedule/schedule.hpp"

#include <algorithm>

#include "drivers/measurement/earlier.hpp"

namespace drydock::fault {

namespace {

using std::chrono::nanoseconds;

bool by_hand(const FaultConfig& fault) { return fault.file.empty(); }

struct Turn {
  Stamp since{};
  std::optional<Stamp> until;
};

std::optional<nanoseconds> length(const std::optional<double>& seconds) {
  return seconds ? std::optional(measurement::from_seconds(*seconds)) : std::nullopt;
}

/// The last turn that began at or before `at`; empty before the first.
std::optional<Turn> last_turn(const FaultConfig& fault, Stamp start, Stamp at) {
  const Stamp first = start + measurement::from_seconds(fault.start_s);
  if (at < first) return {};
  Turn turn{first, {}};
  if (const auto period = length(fault.every_s)) turn.since += (at - first) / *period * *period;
  if (const auto lasts = length(fault.for_s)) turn.until = turn.since + *lasts;
  return turn;
}

std::optional<Stamp> change_after(const FaultConfig& fault, Stamp start, Stamp at) {
  const auto turn = last_turn(fault, start, at);
  if (!turn) return start + measurement::from_seconds(fault.start_s);
  if (turn->until && at < *turn->until) return turn->until;
  if (const auto period = length(fault.every_s)) return turn->since + *period;
  return {};
}

bool is_over(const FaultConfig& fault, Stamp start, Stamp at) {
  const auto turn = last_turn(fault, start, at);
  return turn && turn->until && *turn->until <= at && !fault.every_s;
}

}  // namespace

const InForce* find(const std::vector<InForce>& faults, FaultKind kind) {
  for (auto now = faults.rbegin(); now != faults.rend(); ++now)
    if (now->fault->kind == kind) return &*now;
  return nullptr;
}

void Schedule::add(const FaultConfig& fault) { faults_.push_back(fault); }

void Schedule::set(FaultConfig fault, Stamp now) {
  std::erase_if(faults_, [&](const FaultConfig& other) {
    const bool same = other.kind == fault.kind && other.quantity == fault.quantity;
    return by_hand(other) && (same || is_over(other, start_, now));
  });
  fault.start_s += measurement::seconds(now - start_);
  faults_.push_back(std::move(fault));
  ++edits_;
}

std::size_t Schedule::clear(std::optional<FaultKind> kind) {
  ++edits_;
  return std::erase_if(faults_,
                       [&](const FaultConfig& fault) { return !kind || fault.kind == *kind; });
}

std::vector<InForce> Schedule::in_force(Stamp at) const {
  std::vector<InForce> all;
  for (const FaultConfig& fault : faults_) {
    const auto turn = last_turn(fault, start_, at);
    if (turn && (!turn->until || at < *turn->until))
      all.push_back({&fault, turn->since, turn->until});
  }
  return all;
}

std::optional<Stamp> Schedule::next_change(Stamp after) const {
  std::optional<Stamp> next;
  for (const FaultConfig& fault : faults_)
    next = measurement::earlier(next, change_after(fault, start_, after));
  return next;
}

}  // namespace drydock::fault
