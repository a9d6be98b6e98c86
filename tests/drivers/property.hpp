#pragma once

#include <rapidcheck.h>

#include <functional>

namespace drydock {

/// A property that draws its values inside. RapidCheck builds some thirty templates for each type
/// of property. All typed suites use this one type.
inline bool holds(const std::function<void()>& property) { return rc::check(property); }

}  // namespace drydock
