#include "hil/fault/schedule/chronicle.hpp"

#include <algorithm>

namespace drydock::fault {

namespace {

bool same_turn(const FaultNow& a, const FaultNow& b) {
  return a.device == b.device && a.words == b.words && a.since == b.since;
}

bool holds(const std::vector<FaultNow>& faults, const FaultNow& one) {
  return std::ranges::any_of(faults, [&](const FaultNow& other) { return same_turn(one, other); });
}

}  // namespace

Chronicle::Chronicle(const Injector& injector, Stamp start)
    : injector_(injector), followed_(start - std::chrono::nanoseconds{1}) {}

void Chronicle::follow(Stamp now) {
  for (auto next = deadline(); next && *next <= now; next = deadline()) {
    followed_ = *next;
    compare(*next);
  }
  followed_ = std::max(followed_, now);
  compare(now);
}

void Chronicle::compare(Stamp at) {
  auto now = injector_.in_force(at);
  for (const FaultNow& before : in_force_) {
    if (holds(now, before)) continue;
    const Episode ended{before.device, before.words, before.since, at};
    keep(ended);
    on_change_(ended);
  }
  for (const FaultNow& fault : now) {
    if (holds(in_force_, fault)) continue;
    const Episode begun{fault.device, fault.words, fault.since, {}};
    keep(begun);
    on_change_(begun);
  }
  in_force_ = std::move(now);
}

/// An episode that ends closes the entry of its beginning.
void Chronicle::keep(const Episode& episode) {
  if (episode.until) {
    const auto open = std::ranges::find_if(episodes_, [&](const Episode& kept) {
      return !kept.until && kept.device == episode.device && kept.words == episode.words &&
             kept.since == episode.since;
    });
    if (open != episodes_.end()) open->until = episode.until;
  } else if (episodes_.size() < most_kept) {
    episodes_.push_back(episode);
  } else {
    ++not_kept_;
  }
}

}  // namespace drydock::fault
