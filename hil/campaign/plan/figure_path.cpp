#include "hil/campaign/plan/figure_path.hpp"

#include <charconv>
#include <cmath>

namespace drydock::campaign {
namespace {

using Json = nlohmann::json;

const Json* element(const Json& array, std::string_view step) {
  for (const Json& one : array)
    if (one.is_object() && one.contains("name") && one["name"] == step) return &one;
  std::size_t i = 0;
  const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), i);
  const bool index = error == std::errc{} && end == step.data() + step.size();
  return index && i < array.size() ? &array[i] : nullptr;
}

const Json* member(const Json& object, std::string_view step) {
  const auto found = object.find(step);
  return found == object.end() ? nullptr : &*found;
}

std::optional<double> finite_number(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? 1 : 0;
  if (!value.is_number()) return std::nullopt;
  const auto number = value.get<double>();
  return std::isfinite(number) ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<double> figure_at(const Json& document, std::string_view path) {
  const Json* at = &document;
  while (at && !path.empty()) {
    path.remove_prefix(1);
    const auto step = path.substr(0, path.find('/'));
    path.remove_prefix(step.size());
    if (step == "#" && path.empty() && at->is_array()) return static_cast<double>(at->size());
    if (at->is_array())
      at = element(*at, step);
    else
      at = at->is_object() ? member(*at, step) : nullptr;
  }
  return at ? finite_number(*at) : std::nullopt;
}

}  // namespace drydock::campaign
