// Whom the checks believe: who is named, whose own samples show a fault, and what was learned of
// them or beside them.
#include "estimators/consistency/checks.hpp"

namespace drydock::consistency {
namespace {

/// One fault makes several tests rise within so long.
constexpr std::chrono::seconds together{2};

}  // namespace

bool Checks::trusted(const Devices& devices) const {
  return std::ranges::none_of(devices, [&](std::uint16_t device) { return doubts_.has(device); });
}

/// The named ones, those whose own samples show it, and units that repeat one sample: nothing here
/// needs to fire before a rate that stands still is no longer believed.
void Checks::doubt(Stamp at) {
  doubts_.begin(at);
  if (const auto dvl = speeds_.dvl_off()) doubts_.note_guilty(*dvl);
  for (const InertialUnit& unit : tracks_.units)
    if (const auto still = unit.freeze().since(); still && *still < at)
      doubts_.add(unit.device(), *still);
  doubt_named();
  acquit_others(at);
  restart_sums();
  forget_faults();
}

/// While its own samples show a fault, nothing is learned of a device. When they no longer do, what
/// was learned since is forgotten.
void Checks::forget_faults() {
  for (std::size_t i = 0; i < place_.size(); ++i) {
    const auto device = static_cast<std::uint16_t>(i);
    if (doubts_.is_own(device)) {
      speeds_.note_fault(device);
      headings_.note_fault(device);
      heights_.note_fault(device);
      levels_.note_fault(device);
    }
    const auto over = doubts_.own_is_over(device);
    if (!over) continue;
    const Stamp since = *over - together;
    speeds_.forget(device, since);
    headings_.forget(device, since);
    heights_.forget(device, since);
    levels_.forget(device);
  }
}

/// Those of devices that are sound again.
void Checks::restart_sums() {
  for (std::size_t i = 0; i < place_.size(); ++i) {
    const auto device = static_cast<std::uint16_t>(i);
    if (!doubts_.is_over(device)) continue;
    headings_.restart_sums(device);
    heights_.restart_sums(device);
  }
}

/// A device that has stopped is wrong since then.
void Checks::doubt_named() {
  for (const Named& one : names_) {
    const Test& test = *one.by->test;
    const bool stuck = test.sign(one.by->freeze) == diagnosis::Sign::stuck;
    doubts_.add(one.device, stuck ? *one.by->freeze->since() : test.since());
  }
}

/// DVLs and inertial units tell how the vehicle moves, and so they are in all residuals. What the
/// others seemed to do since such a one is wrong counts no more; what they really do shows again.
bool Checks::acquit_others(Stamp at) {
  const auto news = doubts_.news();
  if (!news) return false;
  const Stamp since = *news - together;
  speeds_.acquit(since, doubts_);
  headings_.acquit(since, doubts_);
  heights_.acquit(since, doubts_);
  levels_.acquit(since, doubts_);
  for (const DvlTracks& dvl : tracks_.dvls)
    if (const auto wrong_since = doubts_.news(dvl.device)) speeds_.forget_dvl(*wrong_since, at);
  return true;
}

void Checks::name(Stamp at) {
  names_ = parity_.name(accusations_, doubts_, at);
  doubt_named();
  if (acquit_others(at)) names_ = parity_.name(accusations_, doubts_, at);
}

}  // namespace drydock::consistency
