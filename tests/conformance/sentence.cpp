#include "tests/conformance/sentence.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace drydock::conformance {

namespace {

/// A number, and the weight of its last digit. Hexadecimal if it begins with 0x.
struct Number {
  double value = 0, last_digit = 1;
};

std::optional<Number> number_of(std::string_view text) {
  if (text.starts_with("0x")) {
    unsigned value = 0;
    std::from_chars(text.data() + 2, text.data() + text.size(), value, 16);
    return Number{double(value), 1};
  }
  if (text.starts_with('+')) text.remove_prefix(1);
  Number number;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number.value).ptr;
  if (text.empty() || end != text.data() + text.size()) return {};
  const auto exponent = text.find_first_of("eE");
  const auto point = text.find('.');
  if (point != text.npos && exponent == text.npos)
    number.last_digit = std::pow(10.0, -double(text.size() - point - 1));
  if (exponent != text.npos) number.last_digit = std::abs(number.value) * 1e-9;
  return number;
}

bool is_number(std::string_view text, std::string_view number) {
  const auto a = number_of(text), b = number_of(number);
  return a && b && std::abs(a->value - b->value) < 1e-9;
}

}  // namespace

std::vector<std::string> fields_of(std::string_view sentence) {
  if (sentence.starts_with('$')) sentence.remove_prefix(1);
  auto fields = split(sentence.substr(0, sentence.find('*')), ',');
  for (std::string& field : fields)
    if (const auto tag = field.find('='); tag != field.npos) field.erase(0, tag + 1);
  return fields;
}

void compare(const json& ours, const std::vector<std::string>& theirs, const Layout& layout,
             Comparison& c) {
  const bool valid = layout.valid_column == 0 || (layout.valid_column < theirs.size() &&
                                                  theirs[layout.valid_column] == layout.valid);
  for (const Slot& slot : layout.slots) {
    const json& value =
        slot.element < 0 ? ours.at(slot.key) : ours.at(slot.key).at(std::size_t(slot.element));
    const std::string text = slot.column < theirs.size() ? theirs[slot.column] : "";
    const auto number = number_of(text);
    if (!number || is_number(text, slot.none) || (slot.when_valid && !valid)) {
      c.same(slot.key, value, nullptr);
      continue;
    }
    c.number(slot.key, value, number->value * slot.scale + slot.offset,
             {number->last_digit * std::abs(slot.scale), 1e-12});
  }
}

void compare_sound(std::string_view protocol, const std::string& file, std::size_t line,
                   const std::string& sentence, const Layout* layout, Score& score) {
  const Decoded decoded = decode_bytes(protocol, sentence + "\r\n");
  if (!layout) {
    for (const json& message : decoded.messages) score.unexpected(file, line, message.dump());
    if (decoded.messages.empty()) score.matched(1);
    return;
  }
  if (decoded.messages.empty()) return score.missed(file, line, sentence);
  Comparison c(file, line);
  compare(decoded.messages.front(), fields_of(sentence), *layout, c);
  score.add(c);
  for (std::size_t i = 1; i < decoded.messages.size(); ++i)
    score.unexpected(file, line, decoded.messages[i].dump());
}

void compare_damaged(std::string_view protocol, const std::string& file, std::size_t line,
                     const std::string& sentence, Score& score) {
  const Decoded decoded = decode_bytes(protocol, sentence + "\r\n");
  Comparison c(file, line);
  c.same("refused", decoded.messages.empty() && decoded.frames == 0, true);
  score.add(c);
}

const Layout* find(std::span<const Layout> layouts, std::string_view address) {
  const auto found = std::ranges::find(layouts, address, &Layout::address);
  return found == layouts.end() ? nullptr : &*found;
}

}  // namespace drydock::conformance
