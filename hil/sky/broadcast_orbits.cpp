#include "hil/sky/broadcast_orbits.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hil/sky/orbit.hpp"

namespace drydock::sky {
namespace {

constexpr std::chrono::hours same_orbit_for{12};  // an orbit extrapolated so far is still right
                                                  // within kilometres
constexpr double same_orbit_m = 500e3;
constexpr std::ptrdiff_t witnesses = 4;  // number of records before, and the same number after

/// Distance between the satellite positions that two records of one number give half-way in time.
double disagreement_m(const Ephemeris& a, const Ephemeris& b) {
  const GpsTime middle = a.toe + (b.toe - a.toe) / 2;
  return (satellite_at(a, middle).ecef_m - satellite_at(b, middle).ecef_m).norm();
}

struct Vote {
  int against = 0, in_favour = 0;
  double nearest_m = 0;  ///< smallest disagreement of the votes against
};

/// The votes of the neighbours in time on one record. `sorted` is ordered by satellite and toe.
Vote vote_on(const std::vector<Ephemeris>& sorted, std::ptrdiff_t index) {
  const Ephemeris& record = sorted[static_cast<std::size_t>(index)];
  const auto size = static_cast<std::ptrdiff_t>(sorted.size());
  Vote vote;
  for (auto i = std::max<std::ptrdiff_t>(0, index - witnesses);
       i < std::min(size, index + witnesses + 1); ++i) {
    const Ephemeris& other = sorted[static_cast<std::size_t>(i)];
    if (i == index || other.prn != record.prn) continue;
    if (std::chrono::abs(other.toe - record.toe) > same_orbit_for) continue;
    const double apart_m = disagreement_m(record, other);
    if (apart_m <= same_orbit_m) {
      ++vote.in_favour;
    } else if (++vote.against == 1 || apart_m < vote.nearest_m) {
      vote.nearest_m = apart_m;
    }
  }
  return vote;
}

}  // namespace

BroadcastOrbits::BroadcastOrbits(const std::vector<Ephemeris>& records) {
  for (const Ephemeris& record : records) {
    if (auto why = absurd(record))
      refused_.push_back({record, std::move(*why)});
    else
      records_.push_back(record);
  }
  std::ranges::stable_sort(records_, {},
                           [](const Ephemeris& r) { return std::pair(r.prn, r.toe); });
  refuse_strangers();
}

void BroadcastOrbits::refuse_strangers() {
  std::vector<Ephemeris> kept;
  for (std::size_t i = 0; i < records_.size(); ++i) {
    const Vote vote = vote_on(records_, static_cast<std::ptrdiff_t>(i));
    if (vote.against <= vote.in_favour) {
      kept.push_back(records_[i]);
      continue;
    }
    refused_.push_back(
        {records_[i], fmt::format("{:.0f} km from where the satellite's other records put it "
                                  "({} against, {} for)",
                                  vote.nearest_m / 1000, vote.against, vote.in_favour)});
  }
  records_ = std::move(kept);
}

const Ephemeris* BroadcastOrbits::nearest(int prn, GpsTime time, Health health) const {
  const auto first = std::ranges::lower_bound(
      records_, prn, {}, [](const Ephemeris& r) { return static_cast<int>(r.prn); });
  const Ephemeris* best = nullptr;
  for (auto at = first; at != records_.end() && at->prn == prn; ++at) {
    const Ephemeris& record = *at;
    if (health == Health::healthy && !record.healthy()) continue;
    const auto distance = std::chrono::abs(record.toe - time);
    if (distance > record_holds) continue;
    if (!best || distance < std::chrono::abs(best->toe - time)) best = &record;
  }
  return best;
}

int BroadcastOrbits::usable(GpsTime time) const {
  int count = 0;
  for (int prn = 1; prn <= highest_prn; ++prn) count += nearest(prn, time) ? 1 : 0;
  return count;
}

std::pair<GpsTime, GpsTime> BroadcastOrbits::span() const {
  if (records_.empty()) return {};
  const auto [first, last] = std::ranges::minmax_element(records_, {}, &Ephemeris::toe);
  return {first->toe, last->toe};
}

}  // namespace drydock::sky
