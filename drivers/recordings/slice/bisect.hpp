#pragma once

#include <functional>
#include <string>
#include <vector>

#include "drivers/recordings/record/selection.hpp"

namespace drydock::slice {

/// Whether a slice still shows the failure; empty: the question was broken off.
using StillFails = std::function<std::optional<bool>(const record::Selection& part)>;

struct Bisected {
  record::Selection part;  ///< the smallest found that fails
  std::size_t events = 0;  ///< reads and frames in it
  int runs = 0;
  bool fails_at_all = true;
  bool broken_off = false;
};

/// Cuts the end of a failing recording by bisection, then its start, then link by link: what is
/// left failed when it was tried. Smallest for a failure that more of the recording does not undo.
Bisected bisect(const std::vector<record::Stamp>& times, const std::vector<std::string>& links,
                const StillFails& still_fails);

}  // namespace drydock::slice
