#pragma once

#include <optional>

#include "drivers/host/finding_log.hpp"
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

  /// Call it at the end, before the links are closed.
  Outcome result(const std::string& source, measurement::Stamp end, bool live,
                 bool has_times = true) const;

 private:
  const rig_config::Rig& rig_;
  measurement::Stamp start_;
  std::vector<const device::Device*> devices_;
  std::optional<host::Diagnostician> diagnostician_;
  host::FindingLog findings_;
  summary::Scribe scribe_;
};

}  // namespace drydock::diagnose
