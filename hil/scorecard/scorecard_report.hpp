#pragma once

#include <string>

#include "hil/scorecard/scorecard.hpp"

/// The scorecard for people.
namespace drydock::scorecard {

/// A table for a terminal, and what it comes to.
std::string to_text(const Scorecard& card);

/// One page that loads nothing from elsewhere: the whole as a heat map, one for each device, every
/// wrong number, what the figures mean.
std::string to_html(const Scorecard& card);

/// Faults against devices: the page's first heat map, as a file of its own.
std::string overview_svg(const Scorecard& card);

}  // namespace drydock::scorecard
