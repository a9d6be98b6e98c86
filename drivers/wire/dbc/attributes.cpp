#include "drivers/wire/dbc/attributes.hpp"

#include <algorithm>

namespace drydock::wire::dbc {

AttributeValue Attributes::read_value(Scanner& in) {
  AttributeValue value;
  if (in.next_is('"')) {
    value.text = in.string("the value");
  } else {
    value.number = in.told_number("the value");
  }
  return value;
}

void Attributes::define(Scanner& in) {
  if (!in.next_is('"')) in.word("the kind of object");
  const std::string name = in.string("the attribute's name");
  if (in.word("the attribute's type") == "ENUM") {
    auto& values = enumerations_[name];
    values.clear();
    do {
      values.push_back(in.string("a value"));
    } while (in.accept(','));
  }
  in.skip_to_statement_end();  // the limits of numbers
}

void Attributes::set_default(Scanner& in) {
  const std::string name = in.string("the attribute's name");
  defaults_[name] = read_value(in);
}

void Attributes::set(std::size_t message, const std::string& name, AttributeValue value) {
  if (name == frame_format || name == cycle_time) own_[{name, message}] = std::move(value);
}

std::optional<double> Attributes::of(std::size_t message, const std::string& name) const {
  if (const auto own = own_.find({name, message}); own != own_.end())
    return number(name, own->second);
  const auto found = defaults_.find(name);
  return found != defaults_.end() ? number(name, found->second) : std::nullopt;
}

std::optional<double> Attributes::number(const std::string& name,
                                         const AttributeValue& value) const {
  if (value.number) return value.number;
  const auto values = enumerations_.find(name);
  if (values == enumerations_.end()) return std::nullopt;
  const auto found = std::ranges::find(values->second, value.text);
  if (found == values->second.end()) return std::nullopt;
  return static_cast<double>(found - values->second.begin());
}

}  // namespace drydock::wire::dbc
