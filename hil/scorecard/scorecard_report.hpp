#pragma once

#include <string>

#include "hil/scorecard/scorecard.hpp"

/// The scorecard for people.
namespace drydock::scorecard {

/// A table for a terminal and the totals.
std::string to_text(const Scorecard& card);

/// A page without external resources: a heat map of the whole rig, one for each device, every wrong
/// number, and what the figures mean.
std::string to_html(const Scorecard& card);

/// Faults against devices: the first heat map of the page, as a separate file.
std::string overview_svg(const Scorecard& card);

}  // namespace drydock::scorecard
