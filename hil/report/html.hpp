#pragma once

#include <string>

#include "hil/report/plot.hpp"

/// Pages without scripts and without external resources. They are readable at phone width and have
/// light and dark colours.
namespace drydock::report::html {

std::string escaped(const std::string& text);

/// The plot as a <figure> with an SVG inside. If it cannot be drawn, the text says so.
std::string figure(const Figure& plot);

/// A whole page. `body` is HTML, `title` is text.
std::string page(const std::string& title, const std::string& body);

}  // namespace drydock::report::html
