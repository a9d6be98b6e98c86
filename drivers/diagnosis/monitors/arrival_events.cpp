#include "drivers/diagnosis/monitors/arrival_events.hpp"

#include <algorithm>
#include <bit>

namespace drydock::diagnosis {

void ArrivalEvents::nothing(Stamp at) {
  note(Happened::nothing);
  for (EventTest* test : {&gaps_, &repeats_, &swaps_, &odds_, &backwards_}) test->add(false, at);
}

void ArrivalEvents::lost_from_the_start(Stamp first) {
  while (!gaps_.fired()) gaps_.add(true, first);
}

void ArrivalEvents::happened(Happened what, EventTest& test, Stamp at) {
  test.add(true, at);
  note(what);
}

void ArrivalEvents::note(Happened what) {
  for (std::size_t i = 0; i < history_.size(); ++i)
    history_[i] = history_[i] << 1 | (i == static_cast<std::size_t>(what) ? 1U : 0U);
}

int ArrivalEvents::lately(Happened what) const {
  return std::popcount(history_[static_cast<std::size_t>(what)]);
}

void ArrivalEvents::tell_if_fired(const Teller& teller, Sign sign, const EventTest& test,
                                  std::string_view what, Stamp at) {
  if (test.fired()) teller.tell(sign, test.since(), at, {test.sum(), threshold, what, ""});
}

/// A repeated or held message also pushes others off the raster; more of those is something else.
void ArrivalEvents::tell(const Teller& teller, Stamp at) const {
  const int odd = lately(Happened::odd), swaps = lately(Happened::swap),
            repeats = lately(Happened::repeat);
  if (repeats >= odd)
    tell_if_fired(teller, Sign::repeated, repeats_, "log-likelihood of repeated messages", at);
  if (swaps >= std::max(odd, 3 * lately(Happened::gap)))
    tell_if_fired(teller, Sign::swapped, swaps_, "log-likelihood of messages one place late", at);
  if (odd > std::max(repeats, swaps))
    tell_if_fired(teller, Sign::irregular, odds_, "log-likelihood of messages off the raster", at);
  tell_if_fired(teller, Sign::gaps, gaps_, "log-likelihood of lost messages", at);
}

/// A lost message looks the same at first; then its own stream has a gap.
void ArrivalEvents::tell_order(const Teller& teller, Stamp at) const {
  if (lately(Happened::swap) > 3 * lately(Happened::gap) + 2)
    tell_if_fired(teller, Sign::swapped, swaps_, "log-likelihood of messages out of order", at);
}

void ArrivalEvents::tell_backwards(const Teller& teller, Stamp at) const {
  tell_if_fired(teller, Sign::time_backwards, backwards_, "log-likelihood of times that go back",
                at);
}

}  // namespace drydock::diagnosis
