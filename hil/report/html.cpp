#include "hil/report/html.hpp"

#include <fmt/format.h>

#include <cmath>

#include "hil/report/figure_json.hpp"
#include "hil/report/labelled_tables.hpp"
#include "hil/report/page_parts.hpp"

namespace drydock::report::html {
namespace {

constexpr const char* plot_tag = "<figure class=plot";

/// True if there are values, but each of them is NaN: of a quantity that is not given.
bool is_not_given(const Figure& plot) {
  bool any = false;
  for (const auto& curve : plot.curves)
    for (const double y : curve.y) {
      if (!std::isnan(y)) return false;
      any = true;
    }
  return any;
}

std::string drawn_by() {
  return fmt::format(
      "<noscript>The plots need JavaScript.</noscript>\n<p class=soft>Drag in a plot to zoom; a "
      "double click shows all. Plots over the same time move together. Plots: uPlot (MIT).</p>\n"
      "<script type=module>{}</script>",
      page_script());
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '&': out += "&amp;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  }
  return out;
}

std::string figure(const Figure& plot) {
  if (is_not_given(plot)) return {};
  return fmt::format(
      "{0} aria-label=\"{1}\"><figcaption><span>{1}</span></figcaption>"
      "<script type=application/json>{2}</script></figure>\n",
      plot_tag, escaped(plot.title), to_json(plot));
}

std::string page(const std::string& title, const std::string& body) {
  const bool plots = body.find(plot_tag) != std::string::npos;
  return fmt::format(
      "<!doctype html><html lang=en><meta charset=utf-8><meta name=viewport "
      "content='width=device-width,initial-scale=1'><title>Drydock: {0}</title><style>{1}</style>\n"
      "<h1>{0}</h1>{2}{3}</html>\n",
      escaped(title), page_style(), with_labels(body), plots ? drawn_by() : "");
}

}  // namespace drydock::report::html
