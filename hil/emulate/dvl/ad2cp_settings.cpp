#include "hil/emulate/dvl/ad2cp_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "drivers/wire/text_fields.hpp"

namespace drydock::emulate {
namespace {

using Arguments = std::span<Ad2cpArgument* const>;

Ad2cpArgument* find_argument(Arguments arguments, std::string_view name) {
  const auto found =
      std::ranges::find(arguments, name, [](const auto* each) { return each->name; });
  return found == arguments.end() ? nullptr : *found;
}

std::string in_digits(const Ad2cpArgument& argument) {
  return fmt::format("{:.{}f}", argument.value, argument.decimals);
}

}  // namespace

std::string set_arguments(Arguments arguments, std::string_view text) {
  std::vector<std::pair<Ad2cpArgument*, double>> changes;
  for (wire::TextFields fields(text); fields.remaining() > 0;) {
    const std::string_view field = fields.text(), name = field.substr(0, field.find('='));
    Ad2cpArgument* const argument = find_argument(arguments, name);
    if (argument == nullptr) return fmt::format("unknown argument {}", name);
    const auto value = wire::parse_number(field.substr(std::min(name.size() + 1, field.size())));
    if (!value || *value < argument->lowest || *value > argument->highest)
      return fmt::format("{} must be {} to {}", name, argument->lowest, argument->highest);
    changes.emplace_back(argument, *value);
  }
  if (changes.empty()) return "an argument is missing";
  for (const auto& change : changes) change.first->value = change.second;
  return {};
}

std::optional<std::string> values_of(Arguments arguments, std::string_view text) {
  std::vector<const Ad2cpArgument*> asked;
  for (wire::TextFields fields(text); !text.empty() && fields.remaining() > 0;) {
    const auto* argument = find_argument(arguments, fields.text());
    if (argument == nullptr) return std::nullopt;
    asked.push_back(argument);
  }
  if (asked.empty()) asked.assign(arguments.begin(), arguments.end());
  std::string values;
  for (const auto* argument : asked) {
    if (!values.empty()) values += ',';
    values += in_digits(*argument);
  }
  return values;
}

}  // namespace drydock::emulate
