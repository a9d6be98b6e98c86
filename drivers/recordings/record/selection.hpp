#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/recordings/record/recording.hpp"

namespace drydock::record {

/// Is told how much of long work is done, 0 to 1; false ends it.
using Watch = std::function<bool(double done)>;

/// A part of a recording. A CAN bus belongs to every device on it: its frames do not say whose
/// they are.
struct Selection {
  std::vector<std::string> only;            ///< devices, links, estimators by name; empty: all
  std::optional<Stamp::duration> from, to;  ///< since the recording's first message

  bool takes(const RecordedLink& link) const;
  bool takes(const mcap::Channel& channel) const;  ///< of what was understood
  bool holds(Stamp at, Stamp begin) const;         ///< `from` belongs to it, `to` does not
};

/// Empty, or one line: a name in `only` that the recording does not have, and those that it has.
std::string misfit(const Selection& selection, const Recording& recording);

}  // namespace drydock::record
