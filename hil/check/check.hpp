#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "rig_config/load.hpp"

namespace drydock::check {

/// What every command loads rig files with: link URIs are checked too.
rig_config::LoadOptions load_options();

/// `drydock check`: for each rig, mission, sensor or vehicle file its problems, or `FILE: ok`.
/// Exit code: 0 all are sound, 1 not all.
int check(const std::vector<std::string>& files, std::FILE* out);

}  // namespace drydock::check
