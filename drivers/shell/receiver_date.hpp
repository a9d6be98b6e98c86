#pragma once

#include <chrono>
#include <optional>

#include "drivers/link/uri.hpp"

namespace drydock::shell {

/// The midnight, since 1970, before the first stamp of a log whose stamps have no date: of the day
/// on which the first UTC that a GNSS receiver in it tells is nearest to its stamp. Empty: no
/// receiver tells one.
std::optional<std::chrono::nanoseconds> date_by_receiver(const link::Uri& uri);

}  // namespace drydock::shell
