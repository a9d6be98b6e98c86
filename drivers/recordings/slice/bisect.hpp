#pragma once

#include <functional>
#include <string>
#include <vector>

#include "drivers/recordings/record/selection.hpp"

namespace drydock::slice {

/// True if a slice still shows the failure. Empty if the test was interrupted.
using StillFails = std::function<std::optional<bool>(const record::Selection& part)>;

struct Bisected {
  record::Selection part;  ///< the smallest failing part found
  std::size_t events = 0;  ///< reads and frames in the part
  int runs = 0;
  bool fails_at_all = true;
  bool broken_off = false;
};

/// Shortens a failing recording: first its end by bisection, then its start, then link by link. The
/// result failed in its own test. It is the smallest part, if adding more of the recording never
/// removes the failure.
Bisected bisect(const std::vector<record::Stamp>& times, const std::vector<std::string>& links,
                const StillFails& still_fails);

}  // namespace drydock::slice
