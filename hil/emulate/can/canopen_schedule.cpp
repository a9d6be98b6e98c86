#include "hil/emulate/can/canopen_schedule.hpp"

#include "drivers/measurement/earlier.hpp"

namespace drydock::emulate {
namespace {

bool goes_by_timer(const CanopenPdo& pdo) { return !pdo.is_synchronous() && pdo.timer_ms != 0; }
bool goes_with_samples(const CanopenPdo& pdo) { return !pdo.is_synchronous() && pdo.timer_ms == 0; }

}  // namespace

bool any_synchronous(const CanopenPdos& pdos) {
  for (std::size_t i = 0; i < pdos.size(); ++i)
    if (pdos[i].is_synchronous()) return true;
  return false;
}

bool any_at_samples(const CanopenPdos& pdos) {
  for (std::size_t i = 0; i < pdos.size(); ++i)
    if (goes_with_samples(pdos[i])) return true;
  return false;
}

void CanopenSchedule::begin(const CanopenPdos& pdos, Stamp now) {
  syncs_.fill(0);
  for (std::size_t i = 0; i < pdos.size(); ++i) {
    next_[i].reset();
    if (goes_by_timer(pdos[i])) next_[i] = now + std::chrono::milliseconds{pdos[i].timer_ms};
  }
}

std::optional<Stamp> CanopenSchedule::next_event() const {
  std::optional<Stamp> next;
  for (const auto& at : next_) next = measurement::earlier(next, at);
  return next;
}

CanopenSchedule::Chosen CanopenSchedule::on_sync(const CanopenPdos& pdos) {
  Chosen chosen{};
  for (std::size_t i = 0; i < pdos.size(); ++i) {
    if (!pdos[i].is_synchronous() || ++syncs_[i] < pdos[i].type) continue;
    syncs_[i] = 0;
    chosen[i] = true;
  }
  return chosen;
}

CanopenSchedule::Chosen CanopenSchedule::at_events(const CanopenPdos& pdos, Stamp at) {
  Chosen chosen{};
  for (std::size_t i = 0; i < pdos.size(); ++i) {
    chosen[i] = next_[i] && *next_[i] <= at;
    if (chosen[i]) *next_[i] += std::chrono::milliseconds{pdos[i].timer_ms};
  }
  return chosen;
}

CanopenSchedule::Chosen CanopenSchedule::at_samples(const CanopenPdos& pdos) {
  Chosen chosen{};
  for (std::size_t i = 0; i < pdos.size(); ++i) chosen[i] = goes_with_samples(pdos[i]);
  return chosen;
}

CanopenSchedule::Chosen CanopenSchedule::sent(const CanopenPdos& pdos, Chosen chosen, Stamp at) {
  for (std::size_t i = 0; i < pdos.size(); ++i) {
    const bool too_soon =
        !pdos[i].is_synchronous() && sent_at_[i] && at - *sent_at_[i] < pdos[i].inhibit_time();
    chosen[i] = chosen[i] && pdos[i].is_on() && !too_soon;
    if (chosen[i]) sent_at_[i] = at;
  }
  return chosen;
}

}  // namespace drydock::emulate
