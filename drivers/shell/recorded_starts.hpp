#pragma once

#include <span>
#include <vector>

#include "drivers/shell/played_files.hpp"

namespace drydock::shell {

/// When recordings that play beside each other begin. Those that keep their times of arrival and
/// began within a day of the first one are of one dive: they keep their distances. Others begin at
/// `start`. In the order of `files`.
std::vector<Stamp> recorded_starts(std::span<const PlayedFile> files, Stamp start);

}  // namespace drydock::shell
