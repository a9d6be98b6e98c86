#include "drivers/device/described/joined_messages.hpp"

namespace drydock::device {

using namespace wire::described;

JoinedMessages::State JoinedMessages::add(const Record& record, const Readings& readings,
                                          const measurement::Origin& origin, bool says_age) {
  const Message& message = *record.message;
  const bool begins = !message.follows;
  const bool was_open = latest_ != nullptr;
  const bool goes_on = was_open && !begins && latest_ == &record.plan->messages[*message.follows];
  if (!begins && !goes_on) {
    reset();
    return State::broken;
  }
  if (begins) {
    readings_ = readings;
    origin_ = origin;
  } else {
    if (says_age) origin_.valid_at = origin.valid_at;
    origin_.received_at = origin.received_at;
    for (const TargetRow& row : target_rows)
      if (!readings_.has(row.target)) readings_.set(row.target, readings.get(row.target));
  }
  latest_ = message.leads ? &message : nullptr;
  if (!message.leads) return State::complete;
  return begins && was_open ? State::broken : State::open;
}

}  // namespace drydock::device
