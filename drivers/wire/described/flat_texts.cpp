#include "drivers/wire/described/flat_texts.hpp"

#include <algorithm>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/described/plan.hpp"

namespace drydock::wire::described {
namespace {

constexpr std::size_t word_size = 8;

bool is_wild(const FlatFamily& family, std::size_t i) {
  return family.any_talker && (i == 1 || i == 2);
}

FlatText flat_text(const Plan& plan, std::uint16_t place) {
  const Message& message = plan.messages[place];
  const auto fields = plan.fields_of(message);
  FlatText text{place, message.first_field, static_cast<std::uint8_t>(fields.size()), 0, {}, {},
                {}};
  for (std::size_t n = 0; n < fields.size(); ++n) {
    const auto i = static_cast<std::uint8_t>(n);
    const Field& field = fields[i];
    if (!field.optional) text.fewest = static_cast<std::uint8_t>(i + 1);
    if (field.type == Type::constant) text.constants.push_back(i);
    if (field.type != Type::constant && field.type != Type::ignored)
      text.read.push_back(i);
    else if (!field.key.empty())
      text.blank.push_back(i);
  }
  return text;
}

/// 0: the fields have different ends, or blanks around them count as one.
char separator_of(std::span<const Field> fields) {
  if (fields.empty() || fields.back().end != 0 || fields.back().closed) return 0;
  if (fields.size() == 1) return ',';
  const char end = fields[0].end;
  const bool same = std::ranges::all_of(fields.first(fields.size() - 1),
                                        [&](const Field& field) { return field.end == end; });
  return same && end != ' ' ? end : '\0';
}

bool cut_alike(std::span<const Field> some, std::span<const Field> others) {
  return std::ranges::equal(some, others, [](const Field& a, const Field& b) {
    return a.end == b.end && a.closed == b.closed;
  });
}

FlatFamily family_of(const Plan& plan, const Message& message) {
  FlatFamily family{.head = message.head, .any_talker = message.any_talker};
  for (std::size_t i = 0; i < std::min(word_size, message.head.size()); ++i) {
    if (is_wild(family, i)) continue;
    family.mask |= std::uint64_t{0xFF} << (8 * i);
    family.word |= std::uint64_t{static_cast<std::uint8_t>(message.head[i])} << (8 * i);
  }
  family.by_pattern = message.line != nullptr;
  if (!family.by_pattern) family.separator = separator_of(plan.fields_of(message));
  return family;
}

bool joins(const Plan& plan, const Message& before, const Message& message) {
  return before.head == message.head && before.any_talker == message.any_talker && !before.line &&
         !message.line && cut_alike(plan.fields_of(before), plan.fields_of(message));
}

}  // namespace

FlatTexts::FlatTexts(const Plan& plan) {
  for (unsigned c = 0; c < stops.size(); ++c) {
    const bool printable = (c >= 0x20 && c <= 0x7E) || c == '\t';
    stops[c] = !printable || c == '*' || plan.starts[c];
  }
  for (std::size_t m = 0; m < plan.messages.size(); ++m) {
    const auto i = static_cast<std::uint16_t>(m);
    const Message& message = plan.messages[i];
    if (i == 0 || !joins(plan, plan.messages[i - 1u], message)) {
      families.push_back(family_of(plan, message));
      families.back().first = i;
    }
    ++families.back().count;
    texts.push_back(flat_text(plan, i));
  }
}

bool begins(const FlatFamily& family, Bytes bytes) {
  if (bytes.size() >= word_size && (load_le<std::uint64_t>(bytes, 0) & family.mask) != family.word)
    return false;
  const std::string& head = family.head;
  if (bytes.size() < head.size()) return false;
  if (family.any_talker && head.size() > 2 && !(is_talker(bytes[1]) && is_talker(bytes[2])))
    return false;
  const std::size_t known = bytes.size() >= word_size ? std::min(word_size, head.size()) : 0;
  for (std::size_t i = known; i < head.size(); ++i)
    if (!is_wild(family, i) && bytes[i] != static_cast<std::uint8_t>(head[i])) return false;
  return true;
}

}  // namespace drydock::wire::described
