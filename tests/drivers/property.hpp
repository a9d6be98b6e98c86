#pragma once

#include <rapidcheck.h>

#include <functional>

namespace drydock {

/// A property that draws its values inside. RapidCheck builds some thirty templates for each type
/// it is given; typed suites hand it this one.
inline bool holds(const std::function<void()>& property) { return rc::check(property); }

}  // namespace drydock
