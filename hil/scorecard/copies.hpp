#pragma once

#include <functional>
#include <string>

#include "hil/study/campaign.hpp"

namespace drydock::scorecard {

/// What study::campaign() does, with a copy of this process for each run (fork): so runs go on from
/// a state that is expensive to make and cannot be copied otherwise. `run` returns its outcome as
/// bytes, and changes nothing in this process. Call it in a process of one thread. Returns the
/// number of collected runs. Throws std::runtime_error with what `run` threw, or with the signal
/// that ended it, and std::system_error if there are no more processes.
std::size_t in_copies(std::string_view name, const study::Options& options,
                      study::Progress& progress, const std::function<std::string(std::size_t)>& run,
                      const std::function<void(std::string&&)>& collect);

}  // namespace drydock::scorecard
