#pragma once

#include <string>

namespace drydock::report {

/// The HTML with the name of its column at each cell of the tables that have too many columns for a
/// phone, where the style makes a card of each of their rows. The tables begin with a row of <th>.
std::string with_labels(const std::string& body);

}  // namespace drydock::report
