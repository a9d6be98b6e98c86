#include "drivers/diagnosis/monitors/satellite_monitor.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::diagnosis {
namespace {

using measurement::GnssSatellites;
using measurement::Satellite;

constexpr unsigned seen_enough = 10, fewest_gone = 3, fewest_present = 3, rows_to_tell = 2;
/// Who was not seen for so long is no longer expected.
constexpr std::chrono::seconds forget_after{120};
constexpr double smoothing = 0.05;
constexpr double beyond_usual = 1.5;  // the largest change of the first time may grow so much

std::uint16_t key_of(const Satellite& satellite) {
  return static_cast<std::uint16_t>(static_cast<unsigned>(satellite.constellation) << 8 |
                                    satellite.number);
}

const Satellite* find_signal(const GnssSatellites& message, std::uint16_t key) {
  for (const Satellite& satellite : message.satellites)
    if (key_of(satellite) == key && satellite.cno_dbhz.value_or(0) > 0) return &satellite;
  return nullptr;
}

}  // namespace

void SatelliteMonitor::take(const GnssSatellites& message) {
  const Stamp now = message.origin.received_at;
  const Change seen = change(message);
  if (!is_usual(seen, now) && tell(seen, now)) return;
  learn(message);
}

/// True while the monitor learns how much a sound antenna changes.
bool SatelliteMonitor::is_usual(const Change& change, Stamp now) {
  if (!first_) first_ = now;
  if (now - *first_ > learning) return false;
  if (change.present >= fewest_present)
    changed_db_ = std::max(changed_db_, beyond_usual * std::abs(change.db));
  gone_share_ = std::max(gone_share_, beyond_usual * change.share());
  return true;
}

SatelliteMonitor::Change SatelliteMonitor::change(const GnssSatellites& message) const {
  Change change;
  const Stamp now = message.origin.received_at;
  for (const Known& known : known_) {
    if (known.seen < seen_enough || now - known.last > forget_after) continue;
    ++change.known;
    const Satellite* const signal = find_signal(message, known.key);
    if (signal == nullptr) {
      ++change.gone;
      continue;
    }
    ++change.present;
    change.db += *signal->cno_dbhz - known.cno_dbhz;
  }
  if (change.present > 0) change.db /= change.present;
  return change;
}

bool SatelliteMonitor::tell(const Change& change, Stamp now) {
  const bool changed = change.present >= fewest_present && std::abs(change.db) > changed_db_;
  const bool gone = change.gone >= fewest_gone && change.share() > gone_share_;
  if (!changed && !gone) {
    since_.reset();
    in_a_row_ = 0;
    return false;
  }
  if (!since_) since_ = now;
  if (++in_a_row_ < rows_to_tell) return true;
  if (changed)
    teller_.tell(Sign::signals_changed, *since_, now,
                 {change.db, std::copysign(changed_db_, change.db), "change of C/N0", "dB"});
  else
    teller_.tell(Sign::satellites_gone, *since_, now,
                 {change.share(), gone_share_, "share of satellites that are gone", ""});
  return now - *since_ < forget_after;
}

void SatelliteMonitor::learn(const GnssSatellites& message) {
  const Stamp now = message.origin.received_at;
  for (const Satellite& satellite : message.satellites) {
    if (satellite.cno_dbhz.value_or(0) <= 0) continue;
    auto known = std::ranges::find(known_, key_of(satellite), &Known::key);
    if (known == known_.end()) {
      if (known_.size() == known_.capacity()) continue;
      known_.push_back({key_of(satellite), *satellite.cno_dbhz, 0, now});
      known = known_.end() - 1;
    }
    if (now - known->last > forget_after) *known = {known->key, *satellite.cno_dbhz, 0, now};
    known->cno_dbhz += smoothing * (*satellite.cno_dbhz - known->cno_dbhz);
    ++known->seen;
    known->last = now;
  }
}

}  // namespace drydock::diagnosis
