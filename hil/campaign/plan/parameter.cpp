#include "hil/campaign/plan/parameter.hpp"

#include <fmt/format.h>

namespace drydock::campaign {

std::string to_text(const Value& value) {
  return std::visit([](const auto& v) { return fmt::format("{}", v); }, value);
}

bool is_number(const Value& value) { return !std::holds_alternative<std::string>(value); }

double number_of(const Value& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  return std::get<double>(value);
}

}  // namespace drydock::campaign
