#include "hil/report/figure_json.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

namespace drydock::report {
namespace {

/// In quotes. Bytes that are no UTF-8 become the replacement character.
std::string json_text(const std::string& text) {
  const auto json =
      nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  std::string out;
  for (const char c : json)
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  return out;
}

std::string number(double value) {
  return std::isfinite(value) ? fmt::format("{:.7g}", value) : "null";
}

std::string numbers(std::span<const double> values) {
  std::string out = "[";
  for (const double value : values) out += (out.size() > 1 ? "," : "") + number(value);
  return out + "]";
}

std::string curve_json(const Curve& curve) {
  return fmt::format(R"({{"label":{},"band":{},"points":{},"x":{},"y":{}}})",
                     json_text(curve.label), curve.band, curve.points, numbers(curve.x),
                     numbers(curve.y));
}

}  // namespace

std::string to_json(const Figure& figure) {
  std::string curves, shades;
  for (const Curve& curve : figure.curves)
    curves += (curves.empty() ? "" : ",") + curve_json(curve);
  for (const Shade& shade : figure.shades)
    shades += (shades.empty() ? "" : ",") + numbers(std::array{shade.from, shade.to});
  return fmt::format(
      R"({{"x_label":{},"y_label":{},"y_limit":{},"equal_scales":{},"log_x":{},"log_y":{},)"
      R"("y_down":{},"shades":[{}],"curves":[{}]}})",
      json_text(figure.x_label), json_text(figure.y_label), number(figure.y_limit),
      figure.equal_scales, figure.log_x, figure.log_y, figure.y_down, shades, curves);
}

}  // namespace drydock::report
