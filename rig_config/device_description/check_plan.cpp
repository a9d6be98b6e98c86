#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "rig_config/device_description/plan_reader.hpp"

namespace drydock::rig_config {
namespace {

namespace described = wire::described;
using described::Field;
using described::Form;
using described::Message;
using described::Plan;
using described::Type;

bool is_wild(const Message& message, std::size_t i) {
  return message.any_talker && (i == 1 || i == 2);
}

/// True if some bytes begin with both heads.
bool heads_meet(const Message& a, const Message& b) {
  for (std::size_t i = 0; i < std::min(a.head.size(), b.head.size()); ++i)
    if (a.head[i] != b.head[i] && !is_wild(a, i) && !is_wild(b, i)) return false;
  return true;
}

bool at_one_place(const Field& a, const Field& b) {
  const auto place = [](const Field& f) {
    return std::tuple(f.record, f.at, f.size, f.big_endian, f.low_word_first, f.first_bit, f.bits);
  };
  return place(a) == place(b);
}

/// True if a constant of one is another constant of the other at the same place.
bool constants_differ(std::span<const Field> a, std::span<const Field> b, Form form) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].type != Type::constant) continue;
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (b[j].type != Type::constant) continue;
      const bool same_place = form == Form::binary ? at_one_place(a[i], b[j]) : i == j;
      const bool differ = form == Form::binary
                              ? a[i].idle != b[j].idle
                              : a[i].text != b[j].text && !a[i].optional && !b[j].optional;
      if (same_place && differ) return true;
    }
  }
  return false;
}

std::size_t fewest(std::span<const Field> fields) {
  return static_cast<std::size_t>(
      std::ranges::count_if(fields, [](const Field& f) { return !f.optional; }));
}

bool separators_differ(std::span<const Field> a, std::span<const Field> b) {
  return !std::ranges::equal(a.first(std::min(a.size(), b.size())),
                             b.first(std::min(a.size(), b.size())), {}, &Field::end, &Field::end);
}

bool counts_differ(std::span<const Field> a, std::span<const Field> b) {
  return fewest(a) > b.size() || fewest(b) > a.size();
}

bool lengths_differ(const Message& a, const Message& b, const Plan& plan) {
  const auto is_fixed = [](const Message& m) { return m.length.size == 0 && !m.length.is_any(); };
  return is_fixed(a) && is_fixed(b) && a.length.fixed != b.length.fixed &&
         (plan.checksum.size() >= 2 || plan.stuffing != described::Stuffing::none);
}

/// A line whose head is longer cannot be the other one, if that continues with a number.
bool longer_head_is_no_number(const Message& a, const Message& b, const Plan& plan) {
  const bool a_longer = a.head.size() > b.head.size();
  const auto fields = plan.fields_of(a_longer ? b : a);
  const char next = a_longer ? a.head[b.head.size()] : b.head[a.head.size()];
  constexpr std::string_view of_numbers = "0123456789+-. ";
  return !fields.empty() && fields[0].type == Type::number &&
         of_numbers.find(next) == of_numbers.npos;
}

bool ambiguous(const Message& a, const Message& b, const Plan& plan) {
  const auto of_a = plan.fields_of(a), of_b = plan.fields_of(b);
  if (!heads_meet(a, b) || constants_differ(of_a, of_b, plan.form)) return false;
  if (plan.form == Form::binary) return !lengths_differ(a, b, plan);
  if (a.line || b.line) return true;  // whether two patterns fit one line, nobody tells
  if (a.head.size() != b.head.size()) return !longer_head_is_no_number(a, b, plan);
  return !(counts_differ(of_a, of_b) || separators_differ(of_a, of_b));
}

/// True if the field has bytes of a checksum that stands in front.
bool in_checksum(const Field& field, const Plan& plan) {
  const auto meets = [&](std::size_t at, std::size_t size) {
    return field.at < at + size && at < field.at + std::size_t{field.size};
  };
  return (plan.checksum_at && meets(*plan.checksum_at, plan.checksum.size())) ||
         (plan.header && meets(plan.header->at, plan.header->checksum.size()));
}

/// What stands outside the frame of a binary message, in words. Empty: nothing.
std::string outside(const Message& message, const Plan& plan) {
  const auto& length = message.length;
  const std::size_t sum = plan.tail();
  const bool fixed = length.size == 0 && !length.is_any();
  const std::size_t longest = fixed ? length.fixed : plan.longest;
  if (longest > plan.longest)
    return fmt::format("has {} bytes, allowed: up to {} ('longest')", longest, plan.longest);
  if (longest < message.head.size() + sum || longest < plan.least())
    return fmt::format("has {} bytes, fewer than its sync, its checksums and its end", longest);
  if (length.size != 0 && length.at + std::size_t{length.size} + sum > plan.longest)
    return "its length is outside of it";
  if (message.records && message.records->from + message.records->header() + sum > longest)
    return "its records begin outside of it";
  for (const Field& field : plan.fields_of(message)) {
    if (field.record && message.records && message.records->are_blocks()) {
      const auto& sizes = message.records->sizes;
      if (*field.record >= sizes.size())
        return fmt::format("a field is in block {}, the last that has a size is {}", *field.record,
                           sizes.size() - 1);
      if (field.at + std::size_t{field.size} > sizes[*field.record])
        return fmt::format("field at {} ends behind the {} bytes of block {}", field.at,
                           sizes[*field.record], *field.record);
    }
    if (field.record) continue;
    if (message.records && field.at + std::size_t{field.size} > message.records->from)
      return fmt::format("field at {} is where the records are, which begin at byte {}", field.at,
                         message.records->from);
    if (field.at < message.head.size() && field.type != Type::ignored)
      return fmt::format("field at {} is in the sync, which ends at byte {}", field.at,
                         message.head.size() - 1);
    if (field.at + std::size_t{field.size} + sum > longest)
      return fmt::format("field at {} ends behind byte {}, where the checksum or the end is",
                         field.at, longest - sum - 1);
    if (field.type != Type::ignored && in_checksum(field, plan))
      return fmt::format("field at {} is in a checksum", field.at);
  }
  return {};
}

/// Two fields that measure and have bits in common, though they are not the same ones. Empty: none.
std::optional<std::pair<std::size_t, std::size_t>> overlap(std::span<const Field> fields) {
  const auto meet = [](const Field& a, const Field& b) {
    if (!a.target || !b.target || a.record != b.record) return false;
    if (at_one_place(a, b) && a.type == b.type) return false;
    const std::size_t end_a = a.at + std::size_t{a.size}, end_b = b.at + std::size_t{b.size};
    if (a.at >= end_b || b.at >= end_a) return false;
    if (a.bits == 0 || b.bits == 0) return true;
    const bool one_integer = a.at == b.at && a.size == b.size && a.big_endian == b.big_endian;
    return one_integer && a.first_bit < b.first_bit + b.bits && b.first_bit < a.first_bit + a.bits;
  };
  for (std::size_t i = 0; i < fields.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (meet(fields[j], fields[i])) return std::pair(j, i);
  return {};
}

}  // namespace

Problems check_plan(const Plan& plan, std::span<const Node> tables, const std::string& file,
                    const std::string& path) {
  Problems problems;
  for (std::size_t i = 0; i < plan.messages.size(); ++i) {
    const auto add = [&](std::string what) {
      problems.push_back({file, tables[i].at.line, tables[i].at.column,
                          fmt::format("{}/{}", path, i), std::move(what)});
    };
    const Message& message = plan.messages[i];
    if (plan.form == Form::binary)
      if (std::string what = outside(message, plan); !what.empty()) add(std::move(what));
    if (const auto pair =
            plan.form == Form::binary ? overlap(plan.fields_of(message)) : std::nullopt)
      add(fmt::format(
          "{} and {} measure the same bytes and are not the same number; allowed: "
          "fields that stand apart, or at one place with one type",
          plan.fields_of(message)[pair->first].key, plan.fields_of(message)[pair->second].key));
    for (std::size_t j = 0; j < i; ++j)
      if (ambiguous(plan.messages[j], message, plan))
        add(
            fmt::format("the same bytes can be this message and that of line {}; allowed: another "
                        "head, number of fields, constant, or (with a checksum of 16 bits) length",
                        tables[j].at.line));
  }
  return problems;
}

}  // namespace drydock::rig_config
