#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drivers/recordings/record/recording.hpp"
#include "hil/replay/rigs/temporary_file.hpp"
#include "rig_config/rig.hpp"

namespace drydock::replay {

/// Another rig for a recording, with what of the two does not fit, one line each.
struct OtherRig {
  rig_config::Rig rig;
  std::vector<std::string> notes = {};
  /// Files that its links name, and that are gone with this.
  std::vector<std::shared_ptr<const TemporaryFile>> files = {};
};

/// Gives each device of the rig the recorded link of the device with the same name. `recorded`: the
/// rig that made the recording. Throws std::runtime_error with one line if no device fits.
OtherRig fit(rig_config::Rig rig, const record::Recording& recording,
             const rig_config::Rig& recorded);

/// Takes the devices out of the rig, and what names them: estimators, which is noted, and
/// expectations.
void leave_out(const std::vector<std::string>& devices, OtherRig& other);

}  // namespace drydock::replay
