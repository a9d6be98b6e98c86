#pragma once

#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rig_config/load.hpp"

namespace drydock::check {

/// Every command loads rig files with these options: link URIs are checked too.
rig_config::LoadOptions load_options();

/// The problems of a file of a kind that only others know. Empty: it is of no such kind.
using CheckOther = std::function<std::optional<rig_config::Problems>(const std::string& file)>;

/// `drydock check`: for each rig, mission, sensor or vehicle file it prints the problems, or `FILE:
/// ok`. Exit code: exit_success, or exit_usage if at least one file is not good.
int check(const std::vector<std::string>& files, std::FILE* out, const CheckOther& other = {});

}  // namespace drydock::check
