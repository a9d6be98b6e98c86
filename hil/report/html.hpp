#pragma once

#include <string>

#include "hil/report/plot.hpp"

/// Pages that need no script and nothing from elsewhere: readable at phone width, light and dark.
namespace drydock::report::html {

std::string escaped(const std::string& text);

/// The plot as a <figure> with an SVG inside; a line that says so where it cannot be drawn.
std::string figure(const Plot& plot);

/// A whole page. `body` is HTML, `title` is text.
std::string page(const std::string& title, const std::string& body);

}  // namespace drydock::report::html
