#pragma once

#include <string>

#include "hil/report/figure.hpp"

/// Pages of one file that load nothing: style, data and the script of the plots stand in it. They
/// are readable at phone width and have light and dark colours.
namespace drydock::report::html {

std::string escaped(const std::string& text);

/// The plot as a <figure> with its data, which the page's script draws. Empty if it has values, but
/// all are NaN: of a quantity that is not given.
std::string figure(const Figure& plot);

/// A whole page, with the script if `body` has plots. `body` is HTML, `title` is text. The rows of
/// tables with many columns become cards on a phone.
std::string page(const std::string& title, const std::string& body);

}  // namespace drydock::report::html
