#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hil/track/outcome.hpp"
#include "hil/twin/statistics.hpp"
#include "hil/twin/surroundings.hpp"

namespace drydock::twin {

/// One device of the recording beside the same of its twin.
struct DeviceBeside {
  std::string name;
  rig_config::DeviceKind kind = rig_config::DeviceKind::imu;
  DeviceStatistics recorded, twin;
};

/// A twin that was written and has sailed.
struct TwinOutcome {
  std::string source, folder;
  double every_s = 0;  ///< between poses
  std::size_t poses = 0;
  Surroundings surroundings;
  track::Outcome recorded;               ///< the track that the twin sails
  std::optional<track::Outcome> sailed;  ///< that of the twin's own measurements
  std::vector<DeviceBeside> devices;
  std::vector<std::string> notes;
};

std::string to_text(const TwinOutcome& outcome);
std::string to_json(const TwinOutcome& outcome);
/// One self-contained HTML page: the tables, and both tracks on a map.
std::string to_html(const TwinOutcome& outcome);

}  // namespace drydock::twin
