#pragma once

#include <map>
#include <optional>
#include <set>

#include "drivers/host/finding_log.hpp"
#include "drivers/host/late_wakes.hpp"
#include "estimators/host/diagnostician.hpp"
#include "hil/diagnose/outcome.hpp"
#include "hil/summary/scribe.hpp"

namespace drydock::diagnose {

/// The followers that make a diagnosis, whatever moves the drivers.
class Examination {
 public:
  /// The rig must outlive the examination. `expected_s` spaces the points of the curves.
  Examination(const rig_config::Rig& rig, measurement::Stamp start, double expected_s);

  /// Adds the examination to followers of others; they then hear the findings too.
  void follow(host::Followers& followers, std::vector<const device::Device*> devices);
  void look(measurement::Stamp now) { diagnostician_->look(now); }
  void await(measurement::Stamp until) { diagnostician_->await(until); }

  /// Call it at the end, before the links are closed. The last ones are those of Circumstances.
  Outcome result(const std::string& source, measurement::Stamp end, bool live,
                 bool has_times = true, bool rates_stated = true) const;

 private:
  /// DVLs whose own depth changed: their mounting and tilts are checked against it.
  struct HeadDepths final : host::Follower {
    void on_measurement(const measurement::Measurement& measurement) override {
      const auto* track = std::get_if<measurement::BottomVelocity>(&measurement);
      if (track == nullptr || !track->depth_m) return;
      const auto [known, is_new] = first_m.try_emplace(track->origin.device, *track->depth_m);
      if (!is_new && known->second != *track->depth_m) changed.insert(known->first);
    }
    std::map<std::uint16_t, double> first_m;
    std::set<std::uint16_t> changed;
  };

  struct Stalls final : host::Follower {
    explicit Stalls(Stamp from) : start(from) {}
    void on_stall(Stamp from, Stamp to) override;
    void on_clock_step(std::chrono::nanoseconds step) override { start += step; }
    Stamp start;
    std::vector<std::string> notes;
  };

  const rig_config::Rig& rig_;
  measurement::Stamp start_;
  std::vector<const device::Device*> devices_;
  std::optional<host::Diagnostician> diagnostician_;
  host::FindingLog findings_;
  summary::Scribe scribe_;
  HeadDepths head_depths_;
  Stalls stalls_;
  host::LateWakes late_wakes_;
};

}  // namespace drydock::diagnose
