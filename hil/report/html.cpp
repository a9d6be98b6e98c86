#include "hil/report/html.hpp"

#include <fmt/format.h>

#include <cmath>

namespace drydock::report::html {
namespace {

constexpr const char* style = R"(
:root{color-scheme:light dark;--ink:#1b1f24;--paper:#fff;--line:#d0d7de;--ok:#1a7f37;--bad:#c0392b;--soft:#57606a}
@media(prefers-color-scheme:dark){:root{--ink:#e6edf3;--paper:#0d1117;--line:#30363d;--ok:#3fb950;--bad:#ff7b72;--soft:#8b949e}}
body{font:15px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--paper);max-width:1060px;margin:2rem auto;padding:0 1rem}
h1{font-size:1.6rem;margin-bottom:.2rem}h2{font-size:1.15rem;margin-top:2rem}
.soft{color:var(--soft)}.scroll{overflow-x:auto}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}
th,td{padding:.3rem .45rem;border-bottom:1px solid var(--line);text-align:right;white-space:nowrap}
th{white-space:normal;vertical-align:bottom}
th:first-child,td:first-child,.left{text-align:left}
.ok{color:var(--ok);font-weight:600}.bad{color:var(--bad);font-weight:600}
figure{margin:1rem 0;background:#fff;border:1px solid var(--line);border-radius:6px;padding:.4rem}
figure svg{width:100%;min-width:620px;height:auto;display:block}
figure{overflow-x:auto}
@media(prefers-color-scheme:dark){figure{border-color:#cfc9c2;filter:invert(.94) hue-rotate(180deg)}}
)";

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
  const auto svg = render_svg(plot);
  if (svg.empty()) {
    return fmt::format("<p class=soft>{}: no plot (is gnuplot installed?)</p>",
                       report::html::escaped(plot.title));
  }
  return "<figure>" + svg + "</figure>\n";
}

std::string page(const std::string& title, const std::string& body) {
  return fmt::format(
      "<!doctype html><html lang=en><meta charset=utf-8><meta name=viewport "
      "content='width=device-width,initial-scale=1'><title>Drydock: {0}</title><style>{1}</style>\n"
      "<h1>{0}</h1>{2}</html>\n",
      report::html::escaped(title), style, body);
}

}  // namespace drydock::report::html
