#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/recordings/record/recording.hpp"

namespace drydock::record {

/// Receives the progress of long work, 0 to 1. False ends the work.
using Watch = std::function<bool(double done)>;

/// A part of a recording. A CAN bus belongs to every device on it: its frames do not name their
/// device.
struct Selection {
  std::vector<std::string> only;            ///< devices, links, estimators by name; empty: all
  std::optional<Stamp::duration> from, to;  ///< since the recording's first message

  bool takes(const RecordedLink& link) const;
  bool takes(const mcap::Channel& channel) const;  ///< for decoded messages
  bool holds(Stamp at, Stamp begin) const;         ///< includes `from`, excludes `to`
};

/// Empty, or one line: the name in `only` that the recording does not have, and the names that it
/// has.
std::string misfit(const Selection& selection, const Recording& recording);

}  // namespace drydock::record
